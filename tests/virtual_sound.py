"""A virtual sound card for tests: a private PulseAudio with null sinks, as any user, without hardware."""

import os
import shutil
import socket
import subprocess
import tempfile
import time
from pathlib import Path

ASOUND = """pcm_type.pulse {{ lib "{plugins}/libasound_module_pcm_pulse.so" }}
ctl_type.pulse {{ lib "{plugins}/libasound_module_ctl_pulse.so" }}
pcm.pulse {{ type pulse hint {{ show on description "PulseAudio" }} }}
ctl.pulse {{ type pulse }}
pcm.!default {{ type pulse hint {{ show on description "Default" }} }}
ctl.!default {{ type pulse }}
"""
START_SECONDS = 10.0


class VirtualSound:
    """Runs while it is entered; programs started with its `environment` hear and speak through it."""

    def __init__(self, rate: int = 44_100) -> None:
        self._rate = rate
        self._folder = Path(tempfile.mkdtemp(prefix="vsound"))
        self._socket = self._folder / "native"

    def __enter__(self) -> "VirtualSound":
        self._server = subprocess.Popen(
            ["pulseaudio", "-n", "--daemonize=no", "--exit-idle-time=-1", "--disable-shm=yes", "--use-pid-file=no",
             "--realtime=no", "--high-priority=no", "--log-target=stderr",
             "-L", f"module-null-sink sink_name=speaker rate={self._rate} channels=2 format=s16le norewinds=1",
             "-L", f"module-native-protocol-unix socket={self._socket} auth-anonymous=1"],
            env=self._server_environment(), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL, start_new_session=True,
        )  # fmt: skip
        self._wait_for_the_socket()
        plugins = next(iter(sorted(Path("/usr/lib").glob("*/alsa-lib"))))
        (self._folder / "asound.conf").write_text(ASOUND.format(plugins=plugins))
        return self

    def __exit__(self, *_error: object) -> None:
        self._server.terminate()
        self._server.wait(5)
        shutil.rmtree(self._folder, ignore_errors=True)

    @property
    def environment(self) -> dict[str, str]:
        """The environment of a program that uses this sound card."""
        return {
            **os.environ,
            "PULSE_SERVER": f"unix:{self._socket}",
            "ALSA_CONFIG_PATH": str(self._folder / "asound.conf"),
            "PULSE_SINK": "speaker",
            "PULSE_COOKIE": str(self._folder / "cookie"),
        }

    def record_speaker(self, path: Path) -> subprocess.Popen[bytes]:
        """Write what is played into a WAV file until terminated."""
        return subprocess.Popen(
            ["parec", "-d", "speaker.monitor", "--format=s16le", "--channels=2", f"--rate={self._rate}",
             "--latency-msec=10", "--file-format=wav", str(path)],
            env=self.environment,
        )  # fmt: skip

    def kill(self) -> None:
        """End the server at once, as a crash would."""
        self._server.kill()
        self._server.wait(5)

    def _server_environment(self) -> dict[str, str]:
        here = str(self._folder)
        environment = {
            **os.environ, "HOME": here, "XDG_RUNTIME_DIR": here, "PULSE_RUNTIME_PATH": here, "PULSE_STATE_PATH": here,
            "PULSE_COOKIE": str(self._folder / "cookie"),
        }  # fmt: skip
        for name in ("PULSE_SERVER", "DBUS_SESSION_BUS_ADDRESS", "DISPLAY"):
            environment.pop(name, None)
        return environment

    def _wait_for_the_socket(self) -> None:
        deadline = time.monotonic() + START_SECONDS
        while time.monotonic() < deadline:
            with socket.socket(socket.AF_UNIX) as connection:
                if connection.connect_ex(str(self._socket)) == 0:
                    return
            time.sleep(0.01)
        raise TimeoutError("the virtual sound server did not start")
