"""A microphone that is plugged in while another is listened to."""

import json
import subprocess
import sys
from pathlib import Path

from tests.fakes.virtual_sound import VirtualSound

DRIVER = Path(__file__).with_name("list_devices.py")


def test_a_new_microphone_is_listed_while_another_is_heard() -> None:
    with VirtualSound() as sound:
        driver = subprocess.Popen(
            [sys.executable, str(DRIVER)],
            env=sound.environment,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
        )
        assert driver.stdin is not None
        assert driver.stdout is not None

        def asked() -> dict[str, object]:
            driver.stdin.write("\n")
            driver.stdin.flush()
            return json.loads(driver.stdout.readline())

        before = asked()
        sound.plug("headset")
        after = asked()
        driver.communicate(timeout=240)
    assert "headset" not in before["names"]
    assert set(after["names"]) == {*before["names"], "headset"}
    assert after["heard"] > before["heard"] > 0
    assert not after["lost"]
