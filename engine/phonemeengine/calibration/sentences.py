"""Sentences that a person reads to be judged by: what is said in them is known, in order, before anybody hears it.

They are spelt in the phonetic alphabet, a space between sounds and ``|`` where a pause may be; what class a sound is
says `phonemeengine.labels.phone_sets`. Each holds all vowels, m, p, s and sh.
"""

from collections.abc import Iterator
from dataclasses import dataclass

from phonemeengine.errors import CorpusError
from phonemeengine.labels.label import CORE
from phonemeengine.labels.phone_sets import AFFRICATE, PhoneClass, phone_classes_in
from phonemeengine.phonemes import Phoneme

PAUSE = "|"
"""Where the speaker may pause; also at the beginning and at the end."""


@dataclass(frozen=True)
class SpokenPhone:
    """One sound of a sentence.

    Attributes
    ----------
    phone : in the phonetic alphabet; empty for a pause.
    sense : what class it is, and how certain that is.
    optional : whether it may be left out, as a pause.
    """

    phone: str
    sense: PhoneClass
    optional: bool = False


@dataclass(frozen=True)
class Sentence:
    """What somebody reads aloud.

    Attributes
    ----------
    language : its name, in English.
    text : as it is shown.
    phones : as it is pronounced.

    Raises
    ------
    CorpusError : a phone is in no alphabet.
    """

    language: str
    text: str
    phones: str

    def __post_init__(self) -> None:
        _ = self.sounds

    @property
    def sounds(self) -> tuple[SpokenPhone, ...]:
        """The sounds in order, with all places where a pause may be."""
        phones = [PAUSE, *self.phones.split(), PAUSE]
        return tuple(sound for phone in phones for sound in _sounds_of(phone))


def _sounds_of(phone: str) -> Iterator[SpokenPhone]:
    """Return a phone's sounds: an affricate is a closure and friction."""
    if phone == PAUSE:
        yield SpokenPhone("", PhoneClass(Phoneme.SILENCE), optional=True)
        return
    sense = phone_classes_in(phone)[1]
    if sense is None:
        raise CorpusError(f"{phone!r} is no sound of the phonetic alphabet; spell the sentence with those of IPA")
    if sense.certainty == AFFRICATE and sense.phoneme is not Phoneme.P:
        yield SpokenPhone(phone, PhoneClass(Phoneme.UNIDENTIFIED, CORE))
    yield SpokenPhone(phone, sense)


SENTENCES = (
    Sentence(
        "English",
        "Papa, may I have some more apple juice, please? She sells sea shells.",
        "p ɑ p ɑ | m eɪ | aɪ | h æ v | s ʌ m | m ɔ ɹ | æ p ə l | dʒ u s | p l i z | ʃ i | s ɛ l z | s i | ʃ ɛ l z",
    ),
    Sentence(
        "German",
        "Meine Mama mag Musik, und Opa schläft am See im Sessel, bis Papa schimpft.",
        "m aɪ n ə | m a m a | m a k | m u z i k | ʊ n t | o p a | ʃ l ɛ f t | a m | z e | ɪ m | z ɛ s ə l | b ɪ s | "
        "p a p a | ʃ ɪ m p f t",
    ),
)
"""Those that the guided calibration offers; the first one where nobody chooses."""
