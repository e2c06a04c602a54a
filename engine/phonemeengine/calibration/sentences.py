"""Sentences that a person reads: what is said in them is known, in order, beforehand.

They are spelt in the phonetic alphabet, a space between sounds and ``|`` where a pause may be; what class a sound is
says `phonemeengine.labels.phone_sets`. Each holds all vowels, m, p, s, and sh where the language has it.
"""

from dataclasses import dataclass

from phonemeengine.errors import CorpusError, remedy
from phonemeengine.labels.phone_sets import ipa_class, split_ipa
from phonemeengine.text.pronunciation import Pronunciation, ScriptWord
from phonemeengine.text.syllables import SpokenSyllable

PAUSE = "|"
"""Where the speaker may pause; also at the beginning and at the end."""


@dataclass(frozen=True)
class Sentence:
    """A text to read aloud.

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
        "Papa, may I have some more apple juice, please? She sells sea shells, maybe on the shore near my house.",
        "p ɑ p ɑ | m eɪ | aɪ | h æ v | s ʌ m | m ɔ ɹ | æ p ə l | dʒ u s | p l i z | ʃ i | s ɛ l z | s i | ʃ ɛ l z | "
        "m eɪ b i | ɑ n | ð ə | ʃ ɔ ɹ | n ɪ ɹ | m aɪ | h aʊ s",
    ),
    Sentence(
        "English",
        "My best sheep sleeps on the moss, and you push the door open for him.",
        "m aɪ | b ɛ s t | ʃ i p | s l i p s | ɑ n | ð ə | m ɔ s | æ n d | j u | p ʊ ʃ | ð ə | d ɔ ɹ | oʊ p ə n | "
        "f ɔ ɹ | h ɪ m",
    ),
    Sentence(
        "German",
        "Meine Mama mag Musik, und Opa schläft am See im Sessel, bis Papa schimpft und Susi eine Suppe isst.",
        "m aɪ n ə | m a m a | m a k | m u z i k | ʊ n t | o p a | ʃ l ɛ f t | a m | z e | ɪ m | z ɛ s ə l | b ɪ s | "
        "p a p a | ʃ ɪ m p f t | ʊ n t | z u z i | aɪ n ə | z ʊ p ə | ɪ s t",
    ),
    Sentence(
        "German",
        "Im Mai sah Opa ein Schaf und ein Pferd, und Susi ließ sie im Moos spielen.",
        "ɪ m | m aɪ | z a | o p a | aɪ n | ʃ a f | ʊ n t | aɪ n | p f e ɐ t | ʊ n t | z u z i | l i s | z i | ɪ m | "
        "m o s | ʃ p i l ə n",
    ),
    Sentence(
        "French",
        "Papa a mis la soupe chaude dans un seau, et le chat mouillé a sauté aussi haut que la petite souris.",
        "p a p a | a | m i | l a | s u p | ʃ o d | d ɑ̃ | z œ̃ | s o | e | l ə | ʃ a | m u j e | a | s o t e | o s i | "
        "o | k ə | l a | p ə t i t | s u ʁ i",
    ),
    Sentence(
        "French",
        "Ma poupée a sali sa chemise, mais Simon cache tout sous le piano.",
        "m a | p u p e | a | s a l i | s a | ʃ ə m i z | m ɛ | s i m ɔ̃ | k a ʃ | t u | s u | l ə | p j a n o",
    ),
    Sentence(
        "Italian",
        "La mia mamma ha preso un pesce fresco, e papà usa una sciarpa; poi il sole sale sopra il muro.",
        "l a | m i a | m a m m a | a | p r e s o | u n | p e ʃ ʃ e | f r e s k o | e | p a p a | u z a | u n a | "
        "ʃ a r p a | p o i | i l | s o l e | s a l e | s o p r a | i l | m u r o",
    ),
    Sentence(
        "Italian",
        "Mio zio esce sempre, poi usa le scimmie di pezza e il sapone.",
        "m i o | ts i o | e ʃ ʃ e | s e m p r e | p o i | u z a | l e | ʃ i m m j e | d i | p e ts ts a | e | i l | "
        "s a p o n e",
    ),
    Sentence(
        "Spanish",
        "Mi mamá puso la mesa, y Pepe sube a su mula con un saco; pasea solo por el monte, si no llueve.",
        "m i | m a m a | p u s o | l a | m e s a | i | p e p e | s u b e | a | s u | m u l a | k o n | u n | "
        "s a k o | p a s e a | s o l o | p o r | e l | m o n t e | s i | n o | ʎ w e b e",
    ),
    Sentence(
        "Spanish",
        "Este sapo come uvas, y mi primo pisa una suma de lápices.",
        "e s t e | s a p o | k o m e | u b a s | i | m i | p r i m o | p i s a | u n a | s u m a | d e | "
        "l a p i s e s",
    ),
)
"""Those that the guided calibration offers, two of each language: the first to learn from, the second to judge by."""

LANGUAGES = tuple(dict.fromkeys(sentence.language for sentence in SENTENCES))
"""A language for which there are sentences; the first one where none is chosen."""


def sentences_in(language: str) -> tuple[Sentence, Sentence]:
    """Return what is read to learn from, and what is read to judge by.

    Raises
    ------
    CorpusError : there is none in this language.
    """
    found = [sentence for sentence in SENTENCES if sentence.language.lower() == language.lower()]
    if not found:
        raise CorpusError(f"there is no sentence in {language!r}; {remedy(language, LANGUAGES)}")
    return found[0], found[1]
