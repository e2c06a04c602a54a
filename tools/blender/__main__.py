"""Builds the add-on's zip into build/blender."""

from tools.blender.build import ROOT, build

if __name__ == "__main__":
    print(build(ROOT / "build" / "blender").relative_to(ROOT))
