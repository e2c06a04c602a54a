"""What a preset may not lose by knowing a voice better."""

from phonemeengine.calibration.scores.scoring import Scores

MOST_LOSS = 0.01
"""By how much a share may get worse."""
GUARDED = (("mouth shapes right", "viseme_accuracy", 1), ("silence found", "silence_recall", 1),
           ("speech called silence", "false_silence", -1))  # fmt: skip
"""What is guarded: in words, the figure's name, and whether more of it is better (1) or worse (-1)."""


def loss_of(before: Scores, after: Scores) -> str:
    """Return what gets worse by more than `MOST_LOSS`, such as "silence found falls from 99.9 % to 39.7 %".

    Empty where nothing does; what the labels do not hold is not asked.
    """
    losses = []
    for words, name, sign in GUARDED:
        old, new = float(getattr(before, name)), float(getattr(after, name))
        if sign * (old - new) > MOST_LOSS:
            losses.append(f"{words} {'falls' if sign > 0 else 'rises'} from {100 * old:.1f} % to {100 * new:.1f} %")
    return " and ".join(losses)
