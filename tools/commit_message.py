"""Checks the message of a commit by the rule of CONTRIBUTING: git calls it with the file that holds the message.

The subject says what in at most 72 letters; an empty line follows; and a change of more than 20 lines has a body that
says why. Merges say what they merge, and are left alone.
"""

import subprocess
import sys
from pathlib import Path

LONGEST_SUBJECT = 72
MOST_LINES_WITHOUT_BODY = 20
SCISSORS = "# ------------------------ >8 ------------------------"


def main() -> int:
    """Check the message in the file that is named."""
    message = Path(sys.argv[1]).read_text(encoding="utf-8")
    complaints = complaints_about(message, changed_lines())
    for complaint in complaints:
        print(f"commit message: {complaint}", file=sys.stderr)
    return 1 if complaints else 0


def complaints_about(message: str, n_changed: int) -> list[str]:
    """Return what is wrong with a message for a change of this many lines; mostly nothing."""
    said = [line for line in message.partition(SCISSORS)[0].splitlines() if not line.startswith("#")]
    subject, *rest = "\n".join(said).strip().splitlines() or [""]
    if not subject or subject.startswith("Merge "):
        return []  # git itself refuses an empty one
    found = []
    if len(subject) > LONGEST_SUBJECT:
        found.append(f"the subject may have {LONGEST_SUBJECT} letters, this has {len(subject)}; shorten it")
    if rest and rest[0].strip():
        found.append("an empty line must follow the subject; add it")
    if n_changed > MOST_LINES_WITHOUT_BODY and not any(line.strip() for line in rest):
        found.append(
            f"a change of more than {MOST_LINES_WITHOUT_BODY} lines needs a body, this has {n_changed}; say why"
        )
    return found


def changed_lines() -> int:
    """Count the lines that the commit adds and deletes; those of binary files do not count."""
    command = ["git", "diff", "--cached", "--numstat"]
    rows = subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()
    return sum(int(n) for row in rows for n in row.split("\t")[:2] if n != "-")


if __name__ == "__main__":
    sys.exit(main())
