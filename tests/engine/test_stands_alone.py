"""The engine needs neither a window nor a sound card."""

import subprocess
import sys

PROGRAM = """
import importlib, pkgutil, sys

REFUSED = {"PySide6", "shiboken6", "pyqtgraph", "sounddevice"}

class Refusal:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in REFUSED:
            raise ModuleNotFoundError(f"{name} is not on this machine", name=name)

sys.meta_path.insert(0, Refusal())

import phonemeengine

def fail(name):
    raise ImportError(name)

names = [module.name for module in pkgutil.walk_packages(phonemeengine.__path__, "phonemeengine.", onerror=fail)]
for name in names:
    if not name.endswith("__main__"):
        importlib.import_module(name)

import numpy as np
from phonemeengine.analyser import analyse_blocks
from phonemeengine.presets.preset import Preset

sound = np.sin(2 * np.pi * 1000 * np.arange(44_100) / 44_100).astype(np.float32)
analyses = list(analyse_blocks([sound], Preset(), pitch=True))
assert sum(len(a) for a in analyses) == 100
assert int(analyses[0].spectra[20].argmax()) == round(1000 * 2048 / 44_100)
assert not REFUSED & {name.partition(".")[0] for name in sys.modules}
print(len(names))
"""


def test_the_engine_stands_without_qt_and_without_a_sound_card():
    done = subprocess.run([sys.executable, "-c", PROGRAM], capture_output=True, text=True, timeout=240, check=False)
    assert done.returncode == 0, done.stderr
    assert int(done.stdout) >= 20
