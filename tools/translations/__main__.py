"""Takes new texts of the window up into the translations, and compiles them; says what is still to be translated.

``python -m tools.translations fr`` begins another language.
"""

import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path

from phonemeanalyser.desktop.language import LANGUAGES, TRANSLATIONS, WRITTEN_IN
from tools.translations.errors import LIST, errors_in
from tools.translations.sources import sources_in
from tools.translations.ts_file import read_translations, write_translations


def main(begun: Iterable[str] = ()) -> int:
    """Do it for every language, and for those that are begun; the exit code is 1 where a text is untranslated."""
    LIST.write_text("".join(f"{text}\n" for text in errors_in()), "utf-8")
    sources, lacking = sources_in(), 0
    for language in dict.fromkeys((*LANGUAGES, *begun)):
        if language == WRITTEN_IN:
            continue
        path = TRANSLATIONS / f"phonemeanalyser_{language}.ts"
        known = read_translations(path)
        write_translations(path, language, sources, known)
        compile_translations(path)
        missing = [text for text, comment in sources if not known.get((text, comment))]
        lacking += len(missing)
        print(f"{path.name}: {len(sources)} texts, {len(missing)} to be translated")
        for text in missing:
            print(f"    {text}")
    return 1 if lacking else 0


def compile_translations(path: Path) -> None:
    """Make the .qm file that Qt reads of a .ts file."""
    lrelease, made = Path(sys.executable).parent / "pyside6-lrelease", path.with_suffix(".qm.new")
    subprocess.run([str(lrelease), "-silent", str(path), "-qm", str(made)], check=True)
    made.replace(path.with_suffix(".qm"))  # a program that runs has mapped the old one


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
