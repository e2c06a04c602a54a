"""Times of the phones of short recordings of one speaker, whose phones are known: learned from all of them together.

Speech is found by its level. Every phone has three states, a normal distribution of mel cepstra each. They
are estimated from equal parts of the speech; then, in turn, the best path through each recording is found, and they
are estimated anew. At last every boundary moves to the greatest change near it.
"""

import numpy as np
import soxr
from scipy.fft import dct
from scipy.signal import butter, sosfiltfilt

from tools.voices.labels import Segment

PAUSE = "pau"
SAMPLE_RATE, HOP, WINDOW, BINS = 16000, 80, 320, 512
BANDS, COEFFICIENTS = 26, 13
HIGHEST = 7800.0  # Hz
STATES, ROUNDS = 3, 12
FLOOR = 0.05  # of the variance of all frames
NEAR, REACH = 3, 8  # frames: compared at either side of a boundary, and by which it may move
VOICE, HISS = (200.0, 4000.0), (4000.0, 7800.0)  # Hz: bands in which the level is measured
VOICE_DROP, HISS_RISE = 22.0, 8.0  # dB below the loudest frame, above the quietest tenth: more of one is speech


def aligned(sounds: list[np.ndarray], sample_rate: int, chains: list[tuple[str, ...]]) -> list[list[Segment]]:
    """Return the segments of each recording: its phones, and the pauses before and after them if there are any.

    Parameters
    ----------
    sounds : (n,) samples each.
    chains : the phones of each, without the pauses.
    """
    sounds = [soxr.resample(sound, sample_rate, SAMPLE_RATE) for sound in sounds]
    ranges = [speech_range(sound, STATES * len(chain)) for sound, chain in zip(sounds, chains, strict=True)]
    tables = [features_of(sound)[first:end] for sound, (first, end) in zip(sounds, ranges, strict=True)]
    names = [*dict.fromkeys(name for chain in chains for name in chain)]
    paths = [np.array([STATES * names.index(name) + k for name in chain for k in range(STATES)]) for chain in chains]
    tracks = [np.arange(len(table)) * len(path) // len(table) for table, path in zip(tables, paths, strict=True)]
    for _ in range(ROUNDS):
        states = np.concatenate([path[track] for path, track in zip(paths, tracks, strict=True)])
        means, variances = _estimated(np.concatenate(tables), states, STATES * len(names))
        tracks = [
            best_track(_scores(table, means[path], variances[path]))
            for table, path in zip(tables, paths, strict=True)
        ]
    starts = [
        first + sharpened(np.searchsorted(track, np.arange(0, len(path), STATES)), table)
        for track, path, table, (first, _) in zip(tracks, paths, tables, ranges, strict=True)
    ]
    return [
        _segments(np.append(inner, end), chain, len(sound) / SAMPLE_RATE)
        for inner, (_, end), chain, sound in zip(starts, ranges, chains, sounds, strict=True)
    ]


def speech_range(sound: np.ndarray, fewest: int) -> tuple[int, int]:
    """Return the first frame of a recording's speech and the one after its last, at least this many."""
    voice, hiss = (_levels(sound, band) for band in (VOICE, HISS))
    loud = (voice > voice.max() - VOICE_DROP) | (hiss > np.percentile(hiss, 10) + HISS_RISE)
    frames = np.flatnonzero(loud)
    first, end = int(frames[0]), int(frames[-1]) + 1
    return (first, end) if end - first >= fewest else (0, len(voice))


def _levels(sound: np.ndarray, band: tuple[float, float]) -> np.ndarray:
    """Return the level of a band in decibels, frame by frame."""
    filtered = sosfiltfilt(butter(4, band, "band", fs=SAMPLE_RATE, output="sos"), sound)
    return 10 * np.log10((_frames(filtered) ** 2).mean(axis=1) + 1e-10)


def _frames(sound: np.ndarray) -> np.ndarray:
    """Return frames of 20 ms, a row every 5 ms, with their middles at 0, 5 ms, ..."""
    return np.lib.stride_tricks.sliding_window_view(np.pad(sound, WINDOW // 2), WINDOW)[::HOP]


def features_of(sound: np.ndarray) -> np.ndarray:
    """Return mel cepstra and their slopes, (n_frames, 26), without the recording's mean."""
    frames = _frames(np.append(sound[:1], sound[1:] - 0.95 * sound[:-1])) * np.hamming(WINDOW)
    power = np.abs(np.fft.rfft(frames, BINS)) ** 2
    cepstra = dct(np.log(power @ _mel_bands().T + 1e-8), norm="ortho")[:, :COEFFICIENTS]
    cepstra -= cepstra.mean(axis=0)
    padded = np.pad(cepstra, ((3, 3), (0, 0)), mode="edge")
    slopes = sum(k * (padded[3 + k : len(padded) - 3 + k] - padded[3 - k : -3 - k]) for k in (1, 2, 3))
    return np.hstack([cepstra, slopes / 5])


def _mel_bands() -> np.ndarray:
    top = 2595 * np.log10(1 + HIGHEST / 700)
    edges = 700 * (10 ** (np.linspace(0, top, BANDS + 2) / 2595) - 1)
    hertz = np.arange(BINS // 2 + 1) * SAMPLE_RATE / BINS
    low, middle, high = edges[:-2, None], edges[1:-1, None], edges[2:, None]
    return np.maximum(0, np.minimum((hertz - low) / (middle - low), (high - hertz) / (high - middle)))


def _estimated(table: np.ndarray, states: np.ndarray, n_states: int) -> tuple[np.ndarray, np.ndarray]:
    """Return means and variances of all states, (n_states, n_features) each."""
    counts = np.bincount(states, minlength=n_states)[:, None] + 1e-9
    sums = np.zeros((2, n_states, table.shape[1]))
    np.add.at(sums[0], states, table)
    np.add.at(sums[1], states, table**2)
    means = sums[0] / counts
    return means, np.maximum(sums[1] / counts - means**2, FLOOR * table.var(axis=0))


def _scores(table: np.ndarray, means: np.ndarray, variances: np.ndarray) -> np.ndarray:
    """Return the log-likelihoods of frames, (n_frames, n_states)."""
    distances = (table[:, None] - means) ** 2 / variances
    return -0.5 * (distances.sum(axis=2) + np.log(variances).sum(axis=1))


def best_track(scores: np.ndarray) -> np.ndarray:
    """Return the place in its path of each frame, from first to last, at which the sum of scores is highest.

    scores : (n_frames, n_places), not fewer frames than places. Places rise by 0 or 1 from frame to frame.
    """
    n_frames, n_places = scores.shape
    best = np.full(n_places, -np.inf)
    best[0] = scores[0, 0]
    came = np.zeros((n_frames, n_places), dtype=bool)
    for frame in range(1, n_frames):
        before = np.append(-np.inf, best[:-1])
        came[frame] = before > best
        best = np.maximum(before, best) + scores[frame]
    track = np.full(n_frames, n_places - 1)
    for frame in range(n_frames - 1, 0, -1):
        track[frame - 1] = track[frame] - came[frame, track[frame]]
    return track


def sharpened(starts: np.ndarray, table: np.ndarray) -> np.ndarray:
    """Return the first frames of phones, all but the first moved to where the sound changes most near by.

    States take the frames of a transition for the phone before: their variance grows with them.
    """
    sums = np.cumsum(np.vstack([np.zeros(COEFFICIENTS), table[:, :COEFFICIENTS]]), axis=0)
    frames = np.arange(len(table))
    before, after = np.maximum(frames - NEAR, 0), np.minimum(frames + NEAR, len(table))
    earlier = (sums[frames] - sums[before]) / np.maximum(frames - before, 1)[:, None]
    later = (sums[after] - sums[frames]) / (after - frames)[:, None]
    change = np.linalg.norm(later - earlier, axis=1)
    moved = starts.copy()
    for k in range(1, len(starts)):
        end = starts[k + 1] if k + 1 < len(starts) else len(table)
        low, high = max(moved[k - 1] + NEAR, starts[k] - REACH), min(starts[k] + REACH, end - NEAR)
        if low < high:
            moved[k] = low + int(np.argmax(change[low:high]))
    return moved


def _segments(edges: np.ndarray, chain: tuple[str, ...], duration: float) -> list[Segment]:
    """Return the segments of phones, from the frames at which they begin and the last one ends."""
    times = [0.0, *map(float, np.clip((edges - 0.5) * HOP / SAMPLE_RATE, 0, duration)), duration]
    names = (PAUSE, *chain, PAUSE)
    return [Segment(*times[k : k + 2], name) for k, name in enumerate(names) if times[k + 1] > times[k]]
