"""What the face expresses beside its speech, as sliders ask for it."""

from PySide6.QtCore import QObject, Signal

from phonemeengine.mouth.expression.composer import Expression
from phonemeengine.mouth.expression.streams import expression_presets, held_expression

USUAL_PRIORITY = 0.5


class ExpressionModel(QObject):
    """Knows how far each expression is asked for, and how much of their channels speech has.

    Signals
    -------
    changed : the expression is another one.

    Attributes
    ----------
    shares : how far each is asked for, by name, 0..1.
    priority : of speech on its own channels, 0..1.
    """

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.shares: dict[str, float] = dict.fromkeys(expression_presets(), 0.0)
        self.priority = USUAL_PRIORITY

    @property
    def expression(self) -> Expression | None:
        """What is expressed; None for nothing."""
        asked = {name: share for name, share in self.shares.items() if share}
        return Expression((held_expression(asked),), speech_priority=self.priority) if asked else None

    def set_share(self, name: str, share: float) -> None:
        """Ask for an expression, 0..1."""
        if name in self.shares and self.shares[name] != min(max(share, 0.0), 1.0):
            self.shares[name] = min(max(share, 0.0), 1.0)
            self.changed.emit()

    def set_priority(self, priority: float) -> None:
        """Give speech so much of its own channels, 0..1; the expression has the rest."""
        if self.priority != min(max(priority, 0.0), 1.0):
            self.priority = min(max(priority, 0.0), 1.0)
            self.changed.emit()

    def clear(self) -> None:
        """Express nothing."""
        if any(self.shares.values()):
            self.shares = dict.fromkeys(self.shares, 0.0)
            self.changed.emit()
