"""How networks are trained; PyTorch is not needed to say so."""

from dataclasses import dataclass, replace

BOTH_WAYS = (1, 2, 4, 8, 16, 16, 1, 2)
"""Dilations of the network with 0.5 s of context on both sides."""


@dataclass(frozen=True)
class TrainingConfig:
    """How the small networks and the encoder are trained.

    Attributes
    ----------
    width, dilations, dropout : of the small network.
    centred : whether it looks as far ahead as back.
    n_epochs : times that it goes through everything.
    batch_size, n_frames : size of its batches: excerpts, and the frames of each.
    rate : its highest learning rate.
    n_layers : of the encoder.
    n_encoder_epochs, encoder_batch, n_encoder_frames : the same for the encoder.
    encoder_rate, head_rate : the highest learning rates of what Whisper knows, and of its new head.
    seed : of all chance.
    """

    width: int = 128
    dilations: tuple[int, ...] = (1, 2, 4, 8, 16, 1, 2, 4)
    dropout: float = 0.1
    centred: bool = False
    n_epochs: int = 40
    batch_size: int = 8
    n_frames: int = 400
    rate: float = 4e-3
    n_layers: int = 3
    n_encoder_epochs: int = 12
    encoder_batch: int = 12
    n_encoder_frames: int = 800
    encoder_rate: float = 1.5e-4
    head_rate: float = 2e-3
    seed: int = 1

    def for_files(self) -> "TrainingConfig":
        """Return how the network for files is trained, where that for live sound is trained so."""
        return replace(self, centred=True, dilations=BOTH_WAYS)
