"""Sentences that a person reads to be judged by: what is said in them is known, in order, before anybody hears it.

They are spelt in the phonetic alphabet, a space between sounds and ``|`` where a pause may be; what class a sound is
says `phonemeengine.labels.phone_sets`. Each holds all vowels, m, p, s and sh.
"""

from dataclasses import dataclass

from phonemeengine.errors import CorpusError
from phonemeengine.labels.phone_sets import ipa_class, split_ipa
from phonemeengine.text.pronunciation import Pronunciation, ScriptWord
from phonemeengine.text.syllables import SpokenSyllable

PAUSE = "|"
"""Where the speaker may pause; also at the beginning and at the end."""


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
        for phone in self.sounds:
            if ipa_class(phone) is None:
                raise CorpusError(
                    f"{phone!r} is no sound of the phonetic alphabet; spell the sentence with those of IPA"
                )

    @property
    def words(self) -> tuple[ScriptWord, ...]:
        """What is said between two places where a pause may be, as words of a script."""
        parts = (split_ipa("".join(part.split())) for part in self.phones.split(PAUSE))
        return tuple(ScriptWord(" ".join(part), (Pronunciation((SpokenSyllable(part),)),)) for part in parts)

    @property
    def sounds(self) -> tuple[str, ...]:
        """The sounds in order; an affricate is a closure and friction."""
        return tuple(phone for word in self.words for phone in word.pronunciations[0].phones)


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
