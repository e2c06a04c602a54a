"""A virtual sound card for tests: a private PulseAudio with a microphone and a speaker, without hardware.

The microphone hears what is played into the sink `mic_in`; whatever the speaker plays can be recorded.
"""

import os
import shutil
import socket
import subprocess
import tempfile
import time
from pathlib import Path

from tests.waiting import let_pass

ASOUND = """pcm_type.pulse {{ lib "{plugins}/libasound_module_pcm_pulse.so" }}
ctl_type.pulse {{ lib "{plugins}/libasound_module_ctl_pulse.so" }}
pcm.pulse {{ type pulse hint {{ show on description "PulseAudio" }} }}
ctl.pulse {{ type pulse }}
pcm.!default {{ type pulse hint {{ show on description "Default" }} }}
ctl.!default {{ type pulse }}
"""
START_SECONDS = 60.0


class VirtualSound:
    """Runs while it is entered; programs started with its `environment` hear and speak through it.

    Parameters
    ----------
    rate : sample rate of microphone and speaker, Hz.
    loopback : let the microphone hear what the speaker plays, rather than what is played into it.
    sleepy : let the speaker sleep for up to 2 s before it takes its first sound, as PulseAudio's null sink does.
    """

    def __init__(self, rate: int = 44_100, *, loopback: bool = False, sleepy: bool = False) -> None:
        self._rate = rate
        self._sleepy = sleepy
        self._source = "speaker.monitor" if loopback else "mic"
        self._folder = Path(tempfile.mkdtemp(prefix="vsound"))
        self._socket, self._log = self._folder / "native", self._folder / "log"
        plugins = next(iter(sorted(Path("/usr/lib").glob("*/alsa-lib"))))
        (self._folder / "asound.conf").write_text(ASOUND.format(plugins=plugins))

    def __enter__(self) -> "VirtualSound":
        self._start()
        return self

    def __exit__(self, *_error: object) -> None:
        self._server.terminate()
        self._server.wait(60)
        shutil.rmtree(self._folder, ignore_errors=True)

    @property
    def environment(self) -> dict[str, str]:
        """The environment of a program that uses this sound card, with a home of its own for recordings and notes."""
        home = self._folder / "home"
        home.mkdir(exist_ok=True)
        return {
            **os.environ,
            "HOME": str(home),
            "XDG_DATA_HOME": str(home / "data"),
            "PULSE_SERVER": f"unix:{self._socket}",
            "ALSA_CONFIG_PATH": str(self._folder / "asound.conf"),
            "PULSE_SINK": "speaker",
            "PULSE_SOURCE": self._source,
            "PULSE_COOKIE": str(self._folder / "cookie"),
        }

    @property
    def journal(self) -> Path:
        """Where programs with this environment note their running recordings."""
        return self._folder / "home" / "data" / "PhonemeAnalyser" / "unfinished"

    def play_into_microphone(self, path: Path) -> subprocess.Popen[bytes]:
        """Have the microphone hear a WAV file; ends with it.

        The latency is longer than any recorder's: a shorter one would change how far a null sink works ahead, and so
        shift the microphone's time by some 15 ms. On a busy machine the player may come late by a second.
        """
        return subprocess.Popen(["paplay", "-d", "mic_in", "--latency-msec=1000", str(path)], env=self.environment)

    def record_speaker(self, path: Path) -> subprocess.Popen[bytes]:
        """Write what is played into a WAV file until terminated; a sleepy speaker is not woken by that."""
        latency = 5000 if self._sleepy else 10
        return subprocess.Popen(
            [
                "parec",
                "-d",
                "speaker.monitor",
                "--format=s16le",
                "--channels=2",
                f"--rate={self._rate}",
                f"--latency-msec={latency}",
                "--file-format=wav",
                str(path),
            ],
            env=self.environment,
        )

    def plug(self, name: str) -> None:
        """Add a sound device of a name, which is the same server once more."""
        with (self._folder / "asound.conf").open("a") as file:
            file.write(f'pcm.{name} {{ type pulse hint {{ show on description "{name}" }} }}\n')

    def suspend_microphone(self, suspended: bool) -> None:
        """Have the microphone deliver nothing, not even silence; or go on."""
        self._control("suspend-source", self._source, str(int(suspended)))

    def suspend_speaker(self, suspended: bool) -> None:
        """Have the speaker take nothing; or go on."""
        self._control("suspend-sink", "speaker", str(int(suspended)))

    def kill(self) -> None:
        """End the server at once, as a crash would."""
        self._server.kill()
        self._server.wait(60)

    def restart(self) -> None:
        """Start the server anew after a crash, where running programs look for it."""
        self._start()

    def _start(self) -> None:
        rate = f"rate={self._rate} format=s16le"
        steady = f"{rate} norewinds=1"
        log = os.open(self._log, os.O_WRONLY | os.O_CREAT | os.O_APPEND)
        self._server = subprocess.Popen(
            [
                "pulseaudio",
                "-n",
                "--daemonize=no",
                "--exit-idle-time=-1",
                "--disable-shm=yes",
                "--use-pid-file=no",
                "--realtime=no",
                "--high-priority=no",
                "--log-target=stderr",
                "-L",
                f"module-null-sink sink_name=speaker channels=2 {rate if self._sleepy else steady}",
                "-L",
                f"module-null-sink sink_name=mic_in channels=1 channel_map=mono {steady}",
                "-L",
                "module-remap-source source_name=mic master=mic_in.monitor",
                "-L",
                f"module-native-protocol-unix socket={self._socket} auth-anonymous=1",
            ],
            env=self._server_environment(),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=log,
            start_new_session=True,
        )
        os.close(log)
        self._wait_for_the_socket()

    def _control(self, *words: str) -> None:
        subprocess.run(["pactl", *words], env=self.environment, check=True, timeout=60)

    def _server_environment(self) -> dict[str, str]:
        here = str(self._folder)
        environment = {
            **os.environ,
            "HOME": here,
            "XDG_RUNTIME_DIR": here,
            "PULSE_RUNTIME_PATH": here,
            "PULSE_STATE_PATH": here,
            "PULSE_COOKIE": str(self._folder / "cookie"),
        }
        for name in ("PULSE_SERVER", "DBUS_SESSION_BUS_ADDRESS", "DISPLAY"):
            environment.pop(name, None)
        return environment

    def _wait_for_the_socket(self) -> None:
        deadline = time.monotonic() + START_SECONDS
        while time.monotonic() < deadline and self._server.poll() is None:
            with socket.socket(socket.AF_UNIX) as connection:
                if connection.connect_ex(str(self._socket)) == 0:
                    return
            let_pass(0.01)
        raise TimeoutError(f"the virtual sound server did not start: {self._log.read_text()}")
