"""Takes a picture of the page of the calibration: run by screenshots.py."""

import sys
from pathlib import Path

import numpy as np

from phonemeanalyser.desktop.calibrate.model import CalibrationModel
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import SAMPLE_RATE
from tests.sounds import noise, silence, vowel
from tools.bench.desktop import live_for
from tools.screenshots.desktops import CALIBRATE, shown_desktop

CARDS = Path(__file__).parents[2] / "tests" / "data" / "cards.flac"
FORMANTS = {
    Phoneme.A: (700, 1200, 2500),
    Phoneme.E: (450, 1900, 2500),
    Phoneme.I: (280, 2250, 2900),
    Phoneme.O: (450, 800, 2500),
    Phoneme.U: (310, 800, 2300),
}


def main(out: Path, theme: str, width: int, height: int) -> None:
    """Take made-up sounds, load real labelled speech, and save what the page shows of both."""
    with shown_desktop((width, height), theme, preset="extended") as (desktop, folder):
        desktop.session.open(CARDS)
        calibration = desktop.calibration
        calibration.takes.speaker = "Mara"
        calibration.takes.open(folder / "Recordings" / "My Takes")
        _record_takes(calibration)
        calibration.recordings.load([CARDS])
        desktop.window.show_page(CALIBRATE)
        _settle(calibration)
        page = desktop.window.calibration
        calibration.workbench.choose("m_a1")
        page.takes.speaker.setText(calibration.takes.speaker)
        page.takes.list.setCurrentCell(1, 0)
        _settle(calibration)
        desktop.window.banner.show_error("")
        live_for(0.2)
        desktop.window.grab().save(str(out), "PNG")


def _record_takes(calibration: CalibrationModel) -> None:
    generator = np.random.default_rng(1)
    pause = silence(0.2)
    puffs = np.concatenate([np.concatenate((noise(0.04, 0.2), silence(0.16))) for _ in range(6)])
    spoken = {
        Phoneme.SILENCE: silence(2.0),
        **{phoneme: vowel(formants, 1.2, f0=190) for phoneme, formants in FORMANTS.items()},
        Phoneme.SZ: noise(0.9, 0.1),
        Phoneme.SCH: noise(0.9, 0.9),
        Phoneme.M: vowel((250, 1000, 2200), 0.9, amplitude=0.1),
        Phoneme.P: puffs,
    }
    for phoneme, sound in spoken.items():
        take = np.concatenate((pause, sound, pause))
        take += 0.0005 * generator.standard_normal(len(take), np.float32)
        calibration.takes.add(take[:, np.newaxis], SAMPLE_RATE, phoneme, "Desk Microphone")


def _settle(calibration: CalibrationModel) -> None:
    live_for(0.3)
    while calibration.takes.busy or calibration.recordings.busy or calibration.workbench.measuring.busy:
        live_for(0.1)
    while calibration.workbench.features is not None and calibration.workbench.shown is None:
        live_for(0.1)
    live_for(0.3)


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2], int(sys.argv[3]), int(sys.argv[4]))
