"""Words of the engine that the window shows: it speaks English, and what is listed here is translated."""

import re
from functools import cache

from phonemeanalyser.desktop.language import tr, tr_noop

WORDS = (
    # what is chosen from
    tr_noop("plain"),
    tr_noop("anti-aliased"),
    tr_noop("bands"),
    tr_noop("linear"),
    tr_noop("mel"),
    tr_noop("logarithmic"),
    tr_noop("sine"),
    tr_noop("white noise"),
    tr_noop("pink noise"),
    tr_noop("sweep"),
    tr_noop("vowel"),
    tr_noop("per window"),
    tr_noop("log-odds"),
    tr_noop("ratio"),
    tr_noop("sum"),
    tr_noop("max"),
    tr_noop("mean"),
    tr_noop("raw"),
    tr_noop("filtered"),
    tr_noop("normalised"),
    tr_noop("automatic"),
    tr_noop("letters of pinyin"),
    tr_noop("recorded faces"),
    tr_noop("sounds, by the mouth table"),
    tr_noop("Rectangle"),
    tr_noop("Eleven mouth shapes"),
    tr_noop("Five mouth shapes"),
    tr_noop("anger"),
    tr_noop("disgust"),
    tr_noop("fear"),
    tr_noop("smile"),
    tr_noop("sorrow"),
    tr_noop("surprise"),
    tr_noop("English"),
    tr_noop("French"),
    tr_noop("Spanish"),
    # what a sound can become
    tr_noop("phonemes as a table"),
    tr_noop("phonemes as JSON"),
    tr_noop("phonemes as a TextGrid of Praat"),
    tr_noop("phonemes as labels of Audacity"),
    tr_noop("every frame of 10 ms with all variables, CSV"),
    tr_noop("every frame of 10 ms with all variables, JSON"),
    tr_noop("Audacity label track"),
    tr_noop("weights of 15 visemes"),
    tr_noop("the head or a face of yours"),
    tr_noop("curves for Unity, Godot, pages"),
    # what a preset is shipped for
    tr_noop("C99, for programs of all kinds"),
    tr_noop("the same without the page, as an npm package"),
    tr_noop("WebAssembly and an AudioWorklet, and a page with a talking head"),
    tr_noop("a package for Unity: C#, a talking face and a talking sprite"),
    tr_noop("an add-on for Godot 4 with .NET, with the same two"),
    # units of an utterance, and of a recorded face
    tr_noop("word"),
    tr_noop("syllable"),
    tr_noop("phone"),
    tr_noop("vowel-triphone"),
    tr_noop("consonant-triphone"),
    tr_noop("boundary-triphone"),
    tr_noop("diphone"),
    tr_noop("boundary-diphone"),
    tr_noop("right-half"),
    tr_noop("left-half"),
    # a measurement
    tr_noop("measure"),
    tr_noop("unit"),
    tr_noop("min"),
    tr_noop("duration"),
    tr_noop("level"),
    # what is wrong with a take, and what is left out of a fit
    tr_noop("silent"),
    tr_noop("too short"),
    tr_noop("too quiet"),
    tr_noop("too noisy"),
    tr_noop("clipped"),
    tr_noop("not silent"),
    tr_noop("speaker"),
    tr_noop("take"),
    # groups of thresholds
    tr_noop("Filters"),
    tr_noop("Silence"),
    tr_noop("SZ and SCH"),
    tr_noop("A and E"),
    tr_noop("Sounds"),
    tr_noop("Other sounds"),
    tr_noop("Calm"),
    tr_noop("what shapes the variables"),
    tr_noop("all of these, else it is no silence"),
    tr_noop("SZ if both, SCH if the first only"),
    tr_noop("all of these"),
    tr_noop("A if both, E if the first only"),
    tr_noop("below the first; M if no other"),
    tr_noop("the likeliest is named"),
    tr_noop("lower follows faster"),
    tr_noop("A phoneme stays so long at least. The bar is how long it has been there."),
    tr_noop("Another phoneme follows only where it is the better one by so much. The bar is by how much it is now."),
    # the factory presets
    tr_noop(
        "Rules of your own over frequency bands: every comparison shows its margin, and every limit can be dragged."
    ),
    tr_noop("A small neural network that heard 122 speakers: the surest one, and it adapts to a voice in a minute."),
    tr_noop("The nearest of nine mean spectra wins, as in uLipSync; best made from takes of one voice."),
    tr_noop("The rules of the thesis with hysteresis, on sound that quantising does not fold."),
    tr_noop("The rules of the thesis with hysteresis: fewer changes."),
    tr_noop("The rules of the thesis as it describes them: weak, but every step shows."),
    tr_noop("The rules of the thesis with the 21 numbers of a PhonemeData file."),
    # how it is heard, and listened
    tr_noop("Whisper base and network"),
    tr_noop("not listening"),
    tr_noop("opening the microphone"),
    tr_noop("there is no microphone; plug one in, or check that the sound system runs"),
    tr_noop("sound cannot be played or recorded, since the package sounddevice is missing; pip install sounddevice"),
    tr_noop("sound cannot be played or recorded, since PortAudio is missing or broken; install libportaudio2"),
    tr_noop("no sound card: silent, on the clock"),
)
"""Those that stand alone."""
SPOKEN = (
    tr_noop("Albanian"),
    tr_noop("Amharic"),
    tr_noop("Arabic"),
    tr_noop("Aragonese"),
    tr_noop("Armenian (East Armenia)"),
    tr_noop("Armenian (West Armenia)"),
    tr_noop("Assamese"),
    tr_noop("Azerbaijani"),
    tr_noop("Bashkir"),
    tr_noop("Basque"),
    tr_noop("Belarusian"),
    tr_noop("Bengali"),
    tr_noop("Bosnian"),
    tr_noop("Bulgarian"),
    tr_noop("Catalan"),
    tr_noop("Catalan (Balearic)"),
    tr_noop("Catalan (North-western)"),
    tr_noop("Catalan (Valencian)"),
    tr_noop("Chinese (Cantonese)"),
    tr_noop("Chinese (Mandarin)"),
    tr_noop("Chinese (Mandarin, Pinyin)"),
    tr_noop("Chuvash"),
    tr_noop("Croatian"),
    tr_noop("Czech"),
    tr_noop("Danish"),
    tr_noop("Dutch"),
    tr_noop("English (America)"),
    tr_noop("English (America, New York City)"),
    tr_noop("English (Caribbean)"),
    tr_noop("English (Great Britain)"),
    tr_noop("English (Lancaster)"),
    tr_noop("English (Received Pronunciation)"),
    tr_noop("English (Scotland)"),
    tr_noop("English (Shavian alphabet)"),
    tr_noop("English (West Midlands)"),
    tr_noop("Estonian"),
    tr_noop("Finnish"),
    tr_noop("French (Belgium)"),
    tr_noop("French (France)"),
    tr_noop("French (Switzerland)"),
    tr_noop("Gaelic (Irish)"),
    tr_noop("Gaelic (Scottish)"),
    tr_noop("Georgian"),
    tr_noop("German"),
    tr_noop("Greek"),
    tr_noop("Greek (Ancient)"),
    tr_noop("Greenlandic"),
    tr_noop("Guarani"),
    tr_noop("Haitian Creole"),
    tr_noop("Hakka Chinese"),
    tr_noop("Hawaiian"),
    tr_noop("Hebrew"),
    tr_noop("Hungarian"),
    tr_noop("Icelandic"),
    tr_noop("Indonesian"),
    tr_noop("Italian"),
    tr_noop("Japanese"),
    tr_noop("Kazakh"),
    tr_noop("Klingon"),
    tr_noop("Korean"),
    tr_noop("Kurdish"),
    tr_noop("Kyrgyz"),
    tr_noop("Latin"),
    tr_noop("Latvian"),
    tr_noop("Lithuanian"),
    tr_noop("Lule Saami"),
    tr_noop("Luxembourgish"),
    tr_noop("Macedonian"),
    tr_noop("Malay"),
    tr_noop("Maltese"),
    tr_noop("Myanmar (Burmese)"),
    tr_noop("Nahuatl (Classical)"),
    tr_noop("Nepali"),
    tr_noop("Nogai"),
    tr_noop("Norwegian Bokmål"),
    tr_noop("Persian"),
    tr_noop("Persian (Pinglish)"),
    tr_noop("Polish"),
    tr_noop("Portuguese (Brazil)"),
    tr_noop("Portuguese (Portugal)"),
    tr_noop("Punjabi"),
    tr_noop("Romanian"),
    tr_noop("Russian"),
    tr_noop("Russian (Classic)"),
    tr_noop("Russian (Latvia)"),
    tr_noop("Serbian"),
    tr_noop("Shan (Tai Yai)"),
    tr_noop("Sinhala"),
    tr_noop("Slovak"),
    tr_noop("Slovenian"),
    tr_noop("Spanish (Latin America)"),
    tr_noop("Spanish (Spain)"),
    tr_noop("Swahili"),
    tr_noop("Swedish"),
    tr_noop("Tatar"),
    tr_noop("Thai"),
    tr_noop("Totontepec Mixe"),
    tr_noop("Turkish"),
    tr_noop("Turkmen"),
    tr_noop("Ukrainian"),
    tr_noop("Uyghur"),
    tr_noop("Uzbek"),
    tr_noop("Vietnamese (Central)"),
    tr_noop("Vietnamese (Northern)"),
    tr_noop("Vietnamese (Southern)"),
    tr_noop("Welsh"),
)
"""Languages of espeak-ng, but for those that are called the same in all languages."""
SENTENCES = (
    tr_noop("twin, {seconds} s each way"),
    tr_noop("encoder and network, {ms} ms ahead"),
    tr_noop("{recogniser}, {ms} ms ahead"),
    tr_noop("waiting for the first sound from {microphone}"),
    tr_noop("nothing comes from {microphone} since {seconds} s; trying again every 2 s"),
    tr_noop("nothing comes from {microphone}"),
    tr_noop("{microphone} has gone"),
    tr_noop("the microphone {name} is not there; choose one of: {names}"),
    tr_noop("{trouble}; trying again every 2 s"),
    tr_noop("the sound card cannot be opened ({reason})"),
    tr_noop("the sound system does not answer ({reason}); check that it runs"),
    tr_noop("only {n} of {n_played} clicks were heard; turn the loudspeaker up, or move the microphone"),
    tr_noop("{rest}, {n} channels are mixed to one"),
    tr_noop("{rest}, only channel {k} of {n} is used"),
    tr_noop("{rest}, shorter than one window ({ms} ms), so silence surrounds it"),
    tr_noop("add {take}"),
    tr_noop("trim {take}"),
    tr_noop("relabel {take}"),
    tr_noop("exclude {take}"),
    tr_noop("include {take}"),
    tr_noop("delete {take}"),
    tr_noop("restore {take}"),
    tr_noop("PhonemeData name: {name}, in bins there, in Hz here"),
    tr_noop("PhonemeData name: {name}"),
    tr_noop("{n} conditions of the rules for {phonemes} compare {variable} with this"),
    tr_noop(
        "added to the log-odds of {phoneme}: each +1 makes it 2.7 times likelier. The bar is by how much it falls "
        "short of the likeliest other one: it is named while the bar is left of the handle."
    ),
    tr_noop("{room} of the room is called silence, and {speech} of the speech in the takes"),
    tr_noop("{room} of the room is called silence"),
    tr_noop(
        "Nothing was heard (the loudest part lies at {db} dB); check that the microphone is on and say it again, "
        "louder or closer."
    ),
    tr_noop(
        "It was too loud for the microphone ({percent}% of the samples are at full scale); say it again, a little "
        "further from the microphone, or turn its level down."
    ),
    tr_noop("It lasted {seconds} s and should last {least} s or more; say it again and hold it."),
    tr_noop(
        "It lies {db} dB above the room and should lie {least} dB above it, and the room is loud ({room} dB); make "
        "it quieter or come closer to the microphone, and say it again."
    ),
    tr_noop(
        "It lies {db} dB above the room and should lie {least} dB above it; say it again, louder or closer to the "
        "microphone."
    ),
    tr_noop(
        "It reached {db} dB and should reach {least} dB; say it again, louder or closer, or turn the microphone's "
        "level up."
    ),
    tr_noop("The silence lasted {seconds} s and should last {least} s or more; keep quiet for longer."),
    tr_noop(
        "Something was heard in the silence ({db} dB, where the room has {room} dB); keep quiet and record it again."
    ),
    tr_noop("{name}: there is no such file; check its name and folder"),
    tr_noop("{name}: this is not a sound file that can be read; choose a WAV, AIFF, FLAC, OGG, MP3 or M4A file"),
    tr_noop("{name}: this kind of file needs the package av, which is not installed; install it with: {command}"),
    tr_noop("{about}, the recording peaks at {peak} dBFS; amplified by {gain} dB for recognition"),
    tr_noop("{about}, its channels cancel each other out when mixed; channel {number} is turned over"),
    tr_noop("{about}, only channel {number} of {n} sounds and is used"),
    tr_noop("{about}, only the channels {numbers} of {n} sound and are mixed"),
    tr_noop("{name}; its channels cancel each other out when mixed, so choose one of them"),
    tr_noop("{name}: it is cut off behind its sound, which is whole"),
    tr_noop("{name}: its header does not say how long it is; {there} s are there"),
    tr_noop("{name}: it is cut off: of the {announced} s that its header announces, {there} s are there"),
    tr_noop("{name}: this is a folder, not a sound file; choose a file in it"),
    tr_noop("{name}: the file is empty (0 bytes); copy or record it again"),
    tr_noop("{name}: there are no samples in it; record or export it again"),
    tr_noop("{name}: reading it is not permitted; change its permissions or copy it"),
)
"""Those with places for what changes; of two that fit, the first one counts."""
_PLACE = re.compile(r"\\\{(\w+)\\\}")


def tr_engine(text: str) -> str:
    """Return what the engine says in the language of the window, as far as it is listed here; else as it is."""
    found = tr(text)
    if found != text:
        return found
    for sentence in SENTENCES:
        filled = _pattern(sentence).fullmatch(text)
        if filled is not None:
            return tr(sentence).format(**{place: tr_engine(words) for place, words in filled.groupdict().items()})
    return text


@cache
def _pattern(sentence: str) -> re.Pattern[str]:
    """Return what a sentence looks like, with anything in its places."""
    return re.compile(_PLACE.sub(r"(?P<\1>.+?)", re.escape(sentence)), re.DOTALL)
