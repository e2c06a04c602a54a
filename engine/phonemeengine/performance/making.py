"""Making a corpus: sentences, and a synthetic performer that reads them with a voice and a face.

The performer is for demonstration and tests, where no person was recorded. It is a dominance model (M. Cohen, D.
Massaro, Modeling coarticulation in synthetic visual speech, 1993): each sound pulls each channel towards a target,
the more strongly the nearer it is, and the face is their weighted mean. Targets and strengths vary from sound to
sound by a tenth, and a slow noise lies over all channels, so that no two takes are alike. What is made so is named
synthetic wherever it is shown. No mouth table has to do with it: who compares a table of these performances with the
rules compares two things that know nothing of each other.
"""

import os
import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from random import Random

import numpy as np
import tomli_w

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.audio.wav import WavEncoder
from phonemeengine.errors import EngineError, PerformanceError
from phonemeengine.execution import Progress, no_progress, report_progress
from phonemeengine.labels.phone_sets import ARTICULATIONS, letters_of
from phonemeengine.labels.utterance import Utterance, shifted
from phonemeengine.labels.utterance_files import format_utterance
from phonemeengine.mouth.animation import Animation
from phonemeengine.mouth.blendshape_names import ARKIT, both_sides
from phonemeengine.mouth.exports.livelink import lines_of
from phonemeengine.performance.corpus import ABOUT, FORMAT
from phonemeengine.performance.recording import SILENCE, PerformedPhone, phones_of
from phonemeengine.settings import SAMPLE_RATE
from phonemeengine.storage.files import atomic_write, printable_name, reason_of

# Sentences for a performer to read: English ones of a small grammar whose words hold every sound many times.

WORDS: dict[str, str] = {
    "name": "Beth Charlotte George Hugh Joyce Martha Oscar Paul Ruth Shawn Thomas Vivian Yusuf Zoe Phoebe "
    "Judge_Young",
    "who": "baker farmer teacher pilot judge child thief young_woman old_man sailor nurse chef boy_next_door "
    "neighbour watchmaker mayor queen fisherman doctor jockey librarian postman butcher guide",
    "did": "bought watched moved found washed polished measured chose carried pushed pulled borrowed fixed "
    "painted weighed described photographed photocopied hid buried dropped lifted treasured ignored "
    "covered emptied",
    "does": "buy watch move find wash polish measure choose carry push pull borrow fix paint weigh describe bring "
    "hide bury drop lift give_up forget enjoy use avoid",
    "what": "book bowl garage_door wooden_boat thick_jumper map camera vase television beige_curtain "
    "pair_of_gloves toothbrush bicycle mushroom_soup red_apple piano fishing_net puzzle jewel "
    "paper_aeroplane box_of_matches measuring_cup bunch_of_flowers yoghurt old_coin umbrella "
    "loaf_of_bread brown_envelope chess_set oil_lamp",
    "how": "bright heavy smooth enormous cheap foolish usual precious thin mild awful yellow huge empty strong "
    "peculiar vague loyal joyful ashen leather foreign busy quiet damp wealthy",
    "where": "on_the_beach by_the_river in_the_village under_the_bridge near_the_church above_the_shop "
    "at_the_airport behind_the_museum in_our_kitchen outside_the_house along_the_path beyond_the_woods "
    "in_the_workshop beside_the_fire at_the_zoo upstairs",
    "when": "this_morning yesterday on_Thursday last_July before_breakfast after_the_show in_the_evening at_noon "
    "for_years every_February three_weeks_ago once_more on_his_birthday without_a_pause",
    "why": "because_it_was_cheap although_nobody_asked while_the_others_laughed but_he_never_said_why "
    "if_the_weather_holds and_the_children_cheered since_she_had_the_choice so_the_dog_barked "
    "though_it_hurt before_the_bus_moved",
}
"""The words of each kind; an underline is a space."""
FRAMES = (
    "The {who} {did} the {how} {what} {where}.",
    "{name} and the {who} {did} a {what} {when}.",
    "Did {name} {does} that {how} {what}?",
    "{when}, {name} {did} the {what} {where}.",
    "Would you {does} my {what}, please?",
    "The {how} {what} was {how}, {why}.",
    "We {did} it {where}, {why}.",
    "{name} told the {who} to {does} the {how} {what}.",
    "Never {does} the {what} of a {how} {who}!",
    "How {how} the {who} looked {when}!",
)
"""What sentences are like."""
TRIED = 12
"""Sentences that are thought of for each that is taken."""


def sentences(seed: int) -> Iterator[str]:
    """Return sentences without end, no two alike; of some that chance offers, that with the rarest words so far."""
    chance = Random(seed)  # noqa: S311 - no secret
    words = {kind: [word.replace("_", " ") for word in text.split()] for kind, text in WORDS.items()}
    said: set[str] = set()
    counts: Counter[str] = Counter()
    while True:
        offered = [_sentence(chance, words) for _ in range(TRIED)]
        fresh = [sentence for sentence in offered if sentence not in said]
        if fresh:
            chosen = max(fresh, key=lambda sentence: _rarity(sentence, counts))
            said.add(chosen)
            counts.update(_words_in(chosen))
            yield chosen


def _sentence(chance: Random, words: dict[str, list[str]]) -> str:
    frame = chance.choice(FRAMES)
    filled = re.sub(r"\{(\w+)\}", lambda found: chance.choice(words[found[1]]), frame)
    spelt = re.sub(r"\ba(?= [aeiou](?!ne|se|su))", "an", filled)
    return spelt[0].upper() + spelt[1:]


def _rarity(sentence: str, counts: Counter[str]) -> float:
    words = _words_in(sentence)
    return sum(1 / (1 + counts[word]) for word in words) / len(words)


def _words_in(sentence: str) -> list[str]:
    return re.findall(r"[a-z]+", sentence.lower())


LEAD = 0.25
"""Seconds of silence before a sentence."""
Speak = Callable[[str], tuple[Float32Array, Utterance]]
"""Says a text: gives samples, mono at 44.1 kHz, and what is said in them, as `speak` does."""


@dataclass(frozen=True)
class MadeCorpus:
    """A corpus that was made: how many recordings, and how long they are together, seconds."""

    n_recordings: int
    duration: float


def make_corpus(
    folder: str | os.PathLike[str],
    sentences: Iterable[str],
    speak: Speak,
    *,
    seconds: float,
    seed: int = 0,
    language: str = "",
    progress: Progress = no_progress,
) -> MadeCorpus:
    """Have the synthetic performer read sentences, until they are so long or have come to their end.

    Parameters
    ----------
    folder : is made; it must hold nothing.
    speak : the voice.
    seconds : of all recordings together.
    seed : another one gives other takes.
    language : of the sentences, where it is known.

    Raises
    ------
    PerformanceError : there is something in the folder, or it cannot be written.
    EngineError : the voice refuses a sentence.
    Cancelled : it was not wanted any more; the recordings that are there are whole.
    """
    folder = Path(folder)
    name = printable_name(folder)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        if any(folder.iterdir()):
            raise PerformanceError(f"{name}: there are files in this folder already; name a new one")
        about = {"format": FORMAT, "name": folder.resolve().name, "synthetic": True, "language": language}
        (folder / ABOUT).write_text(tomli_w.dumps(about), encoding="utf-8")
        made = MadeCorpus(0, 0.0)
        for number, sentence in enumerate(sentences, 1):
            report_progress(progress, min(made.duration / seconds, 1.0))
            if made.duration >= seconds:
                break
            samples, utterance = _with_lead(*speak(sentence))
            _write_recording(folder / f"synthetic{number:04d}", samples, utterance, (seed, number))
            made = MadeCorpus(number, made.duration + utterance.duration)
    except EngineError:
        raise
    except (OSError, ValueError) as error:
        raise PerformanceError(f"{name}: it cannot be written ({reason_of(error)}); name another folder") from error
    return made


def _with_lead(samples: Float32Array, utterance: Utterance) -> tuple[Float32Array, Utterance]:
    """Return a sound and what is said in it behind some silence."""
    n = round(LEAD * SAMPLE_RATE)
    words = tuple(shifted(word, n / SAMPLE_RATE) for word in utterance.words)
    later = replace(utterance, words=words, duration=utterance.duration + n / SAMPLE_RATE)
    return np.concatenate([np.zeros(n, np.float32), samples]), later


def _write_recording(path: Path, samples: Float32Array, utterance: Utterance, seed: tuple[int, int]) -> None:
    """Write a recording's sound, labels and face; the endings are added to the path."""
    with atomic_write(path.with_suffix(".wav")) as file:
        encoder = WavEncoder(file, SAMPLE_RATE, 1)
        encoder.write(samples[:, None])
        encoder.close()
    face = perform(phones_of(utterance), seed)
    for suffix, content in ((".TextGrid", format_utterance(utterance, SILENCE)), (".csv", "".join(lines_of(face)))):
        with atomic_write(path.with_suffix(suffix)) as file:
            file.write(content.encode())


RATE = 60.0
"""Frames a second."""
VARIATION = 0.1
"""Standard deviation of targets and strengths from sound to sound, a share of them."""
NOISE, NOISE_CUTOFF = 0.006, 4.0
"""Standard deviation of the noise, and the frequency (Hz) above which it fades out."""
ASYMMETRY = {"Left": 1.06, "Right": 0.94}
"""How much more or less a side moves than the other."""
HEAD_SWAY, SWAY_CUTOFF = np.array([2.2, 1.4, 1.0]), 0.4
"""Standard deviation of the head's yaw, pitch and roll, degrees, and how fast they change at most, Hz."""
NOD, NOD_LENGTH = -2.5, 0.16
"""How far the head nods at a stressed syllable, degrees; and how long, seconds."""
BLINK_LENGTH, BLINK_EVERY = 0.09, (2.0, 5.0)
"""Seconds."""


@dataclass(frozen=True)
class Pull:
    """What a class of sounds does to a face.

    Attributes
    ----------
    strength : how strongly it pulls the channels that it names, beside a vowel's 1.
    rate : how fast its pull fades with the distance from its middle, 1/s.
    targets : weight by channel; a name without a side stands for both.
    """

    strength: float
    rate: float
    targets: dict[str, float]


REST = Pull(1.6, 14.0, {"jawOpen": 0.02})
"""What silence does."""
SOFTNESS = 0.02
"""Distances are no less than this, seconds: no face turns round at once."""
WEAK = 0.25
"""How strongly a sound pulls the channels that it does not name to 0."""
CONSONANTS = {
    # The first class that a sound belongs to counts.
    "labiovelar": Pull(3.0, 22.0, {"jawOpen": 0.11, "mouthPucker": 0.66, "mouthFunnel": 0.24}),
    "dental": Pull(2.0, 26.0, {"jawOpen": 0.15, "tongueOut": 0.24, "mouthLowerDown": 0.16}),
    "labiodental": Pull(
        7.0, 32.0, {"jawOpen": 0.08, "mouthRollLower": 0.52, "mouthUpperUp": 0.17, "mouthShrugUpper": 0.12}
    ),
    "bilabial": Pull(
        11.0,
        34.0,
        {"jawOpen": 0.05, "mouthClose": 0.06, "mouthPress": 0.38, "mouthRollLower": 0.2, "mouthRollUpper": 0.19},
    ),
    "postalveolar": Pull(
        2.6, 22.0, {"jawOpen": 0.07, "mouthFunnel": 0.5, "mouthPucker": 0.17, "mouthLowerDown": 0.2}
    ),
    "lateral": Pull(1.3, 24.0, {"jawOpen": 0.21, "mouthLowerDown": 0.22, "tongueOut": 0.05}),
    "rhotic": Pull(1.7, 21.0, {"jawOpen": 0.13, "mouthFunnel": 0.33, "mouthPucker": 0.21}),
    "palatal": Pull(1.2, 21.0, {"jawOpen": 0.1, "mouthSmile": 0.24, "mouthStretch": 0.17}),
    "sibilant": Pull(
        1.9, 26.0, {"jawOpen": 0.06, "mouthStretch": 0.24, "mouthLowerDown": 0.19, "mouthUpperUp": 0.09}
    ),
    "alveolar": Pull(1.2, 27.0, {"jawOpen": 0.13, "mouthLowerDown": 0.13, "mouthUpperUp": 0.06}),
    "velar": Pull(0.7, 21.0, {"jawOpen": 0.19, "mouthLowerDown": 0.1}),
    "consonant": Pull(0.4, 19.0, {"jawOpen": 0.22}),
}
HEIGHTS = {
    "open vowel": {"jawOpen": 0.64, "mouthLowerDown": 0.36, "mouthUpperUp": 0.15, "mouthShrugLower": 0.05},
    "close vowel": {"jawOpen": 0.15, "mouthLowerDown": 0.15, "mouthUpperUp": 0.06},
    "vowel": {"jawOpen": 0.38, "mouthLowerDown": 0.26, "mouthUpperUp": 0.11},
}
"""What vowels do to jaw and lips; the first class counts."""
ROUNDINGS = {
    "rounded vowel": {"mouthPucker": 0.57, "mouthFunnel": 0.36},
    "front vowel": {"mouthSmile": 0.19, "mouthStretch": 0.25, "mouthDimple": 0.08},
}
"""What is added to that; the first class counts."""
VOWEL_RATE = 18.0
FOLLOWERS = {
    "cheekSquint": ("mouthSmile", 0.35),
    "noseSneer": ("mouthUpperUp", 0.3),
    "eyeSquint": ("mouthSmile", 0.12),
}
"""Channels that move with another one, by a share of it."""


def perform(phones: Sequence[PerformedPhone], seed: Sequence[int]) -> Animation:
    """Return how the performer's face says phones: all blend shapes of ARKit, and the head.

    Parameters
    ----------
    phones : in order of time, the first from 0.
    seed : whole numbers from 0; others give another take.
    """
    chance = np.random.default_rng([*seed])
    times = np.arange(int(phones[-1].end * RATE + 1e-6) + 1) / RATE
    weights = _pulled(phones, times, chance)
    stresses = [phone.middle for phone in phones if phone.stress == 1 and _is_vowel(phone.name)]
    _add_upper_face(weights, times, stresses, chance)
    noise = _slow_noise(len(times), len(ARKIT), NOISE_CUTOFF, chance)
    head = _slow_noise(len(times), 3, SWAY_CUTOFF, chance) * HEAD_SWAY
    for time in stresses:
        head[:, 1] += NOD * chance.uniform(0.2, 1.4) * _bump(times, time, NOD_LENGTH)
    moved = np.clip(weights + NOISE * noise, 0, 1).astype(np.float32)
    return Animation(RATE, ARKIT, moved, head.astype(np.float32))


def _pulled(phones: Sequence[PerformedPhone], times: Float64Array, chance: np.random.Generator) -> Float64Array:
    """Return the weighted mean of all targets at each time, shape (n_times, n_channels)."""
    pulls = [(time, pull) for phone in phones for time, pull in _pulls_of(phone)]
    middles, rates = np.array([time for time, _ in pulls]), np.array([pull.rate for _, pull in pulls])
    shape = (len(pulls), len(ARKIT))
    named = np.array([_weights_of(pull) for _, pull in pulls])
    strengths = np.array([pull.strength for _, pull in pulls])[:, None]
    strengths = np.where((named > 0) | (strengths == REST.strength), strengths, WEAK)
    strengths = strengths * np.exp(VARIATION * chance.standard_normal(shape))
    targets = named * np.clip(1 + VARIATION * chance.standard_normal(shape), 0.5, 1.5)
    near = np.exp(-rates * np.hypot(times[:, None] - middles, SOFTNESS))
    pulled: Float64Array = (near @ (strengths * targets)) / (near @ strengths)
    return pulled


def _pulls_of(phone: PerformedPhone) -> list[tuple[float, Pull]]:
    """Return what a phone does, and when: each part of a diphthong, and silence all the while."""
    if phone.name == SILENCE:
        n = max(1, round(phone.duration / 0.1))
        return [(phone.start + (k + 0.5) / n * phone.duration, REST) for k in range(n)]
    letters = letters_of(phone.name) or ("ə",)
    part = phone.duration / len(letters)
    return [(phone.start + (k + 0.5) * part, _pull_of(letter)) for k, letter in enumerate(letters)]


def _pull_of(letter: str) -> Pull:
    if not _is_vowel(letter):
        return next(pull for name, pull in CONSONANTS.items() if letter in ARTICULATIONS[name])
    height = next(targets for name, targets in HEIGHTS.items() if letter in ARTICULATIONS[name])
    rounding = next((targets for name, targets in ROUNDINGS.items() if letter in ARTICULATIONS[name]), {})
    return Pull(1.0, VOWEL_RATE, height | rounding)


def _is_vowel(name: str) -> bool:
    return any(letter in ARTICULATIONS["vowel"] for letter in letters_of(name))


def _weights_of(pull: Pull) -> Float64Array:
    """Return the targets of all channels, the ones of the sides not quite alike."""
    weights = np.zeros(len(ARKIT))
    for name, weight in pull.targets.items():
        for side in (name,) if name in ARKIT else both_sides(name):
            factor = next((factor for end, factor in ASYMMETRY.items() if side.endswith(end)), 1.0)
            weights[ARKIT.index(side)] = weight * factor
    return weights


def _add_upper_face(
    weights: Float64Array, times: Float64Array, stresses: Sequence[float], chance: np.random.Generator
) -> None:
    """Add blinks, brows that rise at some stresses, and what follows the mouth."""
    for name, (leader, share) in FOLLOWERS.items():
        for follower, led in zip(both_sides(name), both_sides(leader), strict=True):
            weights[:, ARKIT.index(follower)] += share * weights[:, ARKIT.index(led)]
    for time in stresses:
        if chance.random() < 0.35:
            height = chance.uniform(0.1, 0.45)
            for name, share in (("browInnerUp", 1.0), ("browOuterUpLeft", 0.8), ("browOuterUpRight", 0.7)):
                weights[:, ARKIT.index(name)] += share * height * _bump(times, time, 0.18)
    time = chance.uniform(0.3, BLINK_EVERY[1])
    while time < times[-1]:
        for side in both_sides("eyeBlink"):
            weights[:, ARKIT.index(side)] += _bump(times, time, BLINK_LENGTH)
        time += chance.uniform(*BLINK_EVERY)


def _bump(times: Float64Array, middle: float, length: float) -> Float64Array:
    """Return a Gaussian about a time, 1 there, of a standard deviation in seconds."""
    return np.exp(-(((times - middle) / length) ** 2) / 2)


def _slow_noise(n: int, n_channels: int, cutoff: float, chance: np.random.Generator) -> Float64Array:
    """Return noise of unit variance, shape (n, n_channels), that fades out above a frequency, Hz.

    It is white noise under a Gaussian window in time.
    """
    sigma = RATE / (2 * np.pi * cutoff)
    reach = int(4 * sigma) + 1
    window = np.exp(-((np.arange(-reach, reach + 1) / sigma) ** 2) / 2)
    white = chance.standard_normal((n + 2 * reach, n_channels))
    smooth = [np.convolve(column, window / np.linalg.norm(window), "valid") for column in white.T]
    return np.stack(smooth, axis=1)
