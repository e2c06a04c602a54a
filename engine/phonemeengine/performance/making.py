"""Making a corpus: sentences, and a synthetic performer that reads them with a voice and a face."""

import os
import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from random import Random

import numpy as np
import tomli_w

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.wav import WavEncoder
from phonemeengine.errors import EngineError, PerformanceError
from phonemeengine.execution import Progress, no_progress, report_progress
from phonemeengine.labels.utterance import Utterance, shifted
from phonemeengine.labels.utterance_files import format_utterance
from phonemeengine.mouth.exports.livelink import lines_of
from phonemeengine.performance.corpus import ABOUT, FORMAT
from phonemeengine.performance.recording import SILENCE, phones_of
from phonemeengine.performance.synthetic import perform
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
