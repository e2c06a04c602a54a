"""Words of the engine that the window shows: it speaks English, and what is listed here is translated."""

import re
from functools import cache, lru_cache
from pathlib import Path

from phonemeanalyser.desktop.engine_errors import ERRORS, PARTS
from phonemeanalyser.desktop.language import language_in_use, tr, tr_noop
from phonemeengine.mouth.table import load_table, shipped_tables
from phonemeengine.phonemes import Phoneme

SOUNDS = {
    "silence": tr_noop("silence"),
    "unidentified": tr_noop("unidentified"),
    "sz": tr_noop("s"),
    "sch": tr_noop("sh"),
    "schwa": tr_noop("schwa"),
}
"""Phonemes and mouth shapes that the window calls otherwise than files do, by their labels there."""

RECOGNISERS = {"thesis": "Thesis", "learned": "Learned", "rules": "Extended rules", "templates": "Templates"}
"""The recognisers of the program, by their names in files: each is called as the factory's preset with it."""

WORDS = (
    # what is chosen from
    tr_noop("plain"),
    tr_noop("Any language"),
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
    tr_noop("amplitude"),
    tr_noop("log-odds"),
    tr_noop("ratio"),
    tr_noop("sum"),
    tr_noop("max"),
    tr_noop("mean"),
    tr_noop("raw"),
    tr_noop("filtered"),
    tr_noop("normalised"),
    tr_noop("total energy"),
    tr_noop("highest peak"),
    tr_noop("mean amplitude"),
    tr_noop("zero crossings"),
    tr_noop("volume (peak level)"),
    tr_noop("pitch (f0)"),
    tr_noop("Automatic"),
    tr_noop("Pinyin letters"),
    tr_noop("Recorded faces"),
    tr_noop("Sound alone (network)"),
    tr_noop("Phonemes (rules)"),
    tr_noop("Rectangle"),
    tr_noop("Annosoft phonemes"),
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
    tr_noop("phonemes as a Praat TextGrid"),
    tr_noop("phonemes as Audacity labels"),
    tr_noop("all variables every 10 ms, CSV"),
    tr_noop("all variables every 10 ms, JSON"),
    tr_noop("Audacity label track"),
    tr_noop("weights of 15 visemes"),
    tr_noop("action units (FACS), as OpenFace has them"),
    tr_noop("the default head or a custom face"),
    tr_noop("curves for Unity, Godot and web pages"),
    # what a preset is shipped for
    tr_noop("C99 source for any program"),
    tr_noop("the same as an npm package, without the page"),
    tr_noop("WebAssembly and AudioWorklet, with a page that shows a talking head"),
    tr_noop("Unity package: C#, a talking face and a talking sprite"),
    tr_noop("add-on for Godot 4 (GDScript and C#), with the same two"),
    tr_noop("Unreal plugin: C++, a talking face and Live Link"),
    # units of an utterance, and of a recorded face
    tr_noop("clip"),
    tr_noop("sentence"),
    tr_noop("words"),
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
    tr_noop("amplitude"),
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
    tr_noop("The microphone delivers digital silence, which sets no thresholds; check that it is on and not muted."),
    tr_noop("speaker"),
    tr_noop("take"),
    tr_noop("part"),
    # what is wrong with a rule
    tr_noop("can never hold: two conditions contradict each other"),
    tr_noop("is never reached: an earlier rule holds wherever this one does"),
    tr_noop("never holds in the loaded sound"),
    tr_noop("always holds in the loaded sound: no later rule is reached"),
    tr_noop("decides no frame of the loaded sound: earlier rules do"),
    # groups of thresholds
    tr_noop("Filters"),
    tr_noop("Silence"),
    tr_noop("S and SH"),
    tr_noop("A and E"),
    tr_noop("Sounds"),
    tr_noop("Other sounds"),
    tr_noop("Smoothing"),
    tr_noop("affect the variables"),
    tr_noop("silence if all hold"),
    tr_noop("S if both hold, SH if only the first"),
    tr_noop("if all hold"),
    tr_noop("A if both hold, E if only the first"),
    tr_noop("below the first limit; M if no other"),
    tr_noop("the most likely one is recognised"),
    tr_noop("lower reacts faster"),
    tr_noop("Shortest time for which a phoneme is shown. The bar shows how long the current one has lasted."),
    tr_noop(
        "By how much another phoneme must score higher to replace the current one. The bar shows by how much "
        "it does now."
    ),
    # the factory presets
    tr_noop("The rules of the thesis with the 21 numbers of a PhonemeData file."),
    # the model, and the microphone
    tr_noop("this preset was trained without this model; choose another preset, such as Learned"),
    tr_noop("the speech encoder needs onnxruntime, which is not installed; install phonemeanalyser[encoder]"),
    tr_noop("the model Whisper base is not on this computer; File > Speech Encoder… downloads it"),
    tr_noop("Whisper base and network"),
    tr_noop(
        "programs without Python recognise with the preset's small network; the real-time model with the encoder "
        "needs Python and onnxruntime"
    ),
    tr_noop("not listening"),
    tr_noop("opening the microphone"),
    tr_noop("No audio device (silent playback)"),
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
    tr_noop("{cause} at {seconds} s of {sound}"),
    tr_noop("{start} to {end} s of {sound}"),
    tr_noop("{n} segments of {sound}"),
    tr_noop("{n} sounds"),
    # the factory presets
    tr_noop(
        "Networks trained on 249 speakers; adapts to a voice in a minute"
        ": mouth shapes {percent} % on left-out speakers."
    ),
    tr_noop(
        "Rules over frequency bands whose limits can all be dragged: mouth shapes {percent} % on left-out speakers."
    ),
    tr_noop("The nearest of nine mean spectra, as in uLipSync: mouth shapes {percent} % on left-out speakers."),
    tr_noop("The rules of the thesis, whose every step shows: mouth shapes {percent} % on left-out speakers."),
    tr_noop(
        "The rules of the thesis with hysteresis, for fewer changes: mouth shapes {percent} % on left-out speakers."
    ),
    tr_noop(
        "The rules of the thesis with hysteresis, without aliasing: mouth shapes {percent} % on left-out speakers."
    ),
    tr_noop("{start}, own voice, {day}: mouth shapes {before} to {after} % on held-out speech, changed since"),
    tr_noop("{start}, own voice, {day}: mouth shapes {before} to {after} % on held-out speech"),
    tr_noop("{name} (synthetic performer)"),
    tr_noop("{name} (network, synthetic performer)"),
    tr_noop("{name} (network)"),
    tr_noop("no recording of the network has a {place} sound, so lips may stay apart there"),
    tr_noop("the network does not move {shapes} and {n} more"),
    tr_noop("the network does not move {shapes}"),
    tr_noop("offline, ±{seconds} s of context"),
    tr_noop("encoder, look-ahead {ms} ms"),
    tr_noop("{recogniser} with a decoder, look-ahead {ms} ms"),
    tr_noop("{recogniser}, look-ahead {ms} ms"),
    tr_noop("waiting for a signal from {microphone}"),
    tr_noop("no signal from {microphone} for {seconds} s; trying again every 2 s"),
    tr_noop("no signal from {microphone}"),
    tr_noop("{microphone} was disconnected"),
    tr_noop("the microphone {name} is not connected; choose one of: {names}"),
    tr_noop("{trouble}; trying again every 2 s"),
    tr_noop("{rest}, {n} channels are mixed to one"),
    tr_noop("{rest}, only channel {k} of {n} is used"),
    tr_noop("{rest}, shorter than one window ({ms} ms), padded with silence"),
    tr_noop("add {take}"),
    tr_noop("trim {take}"),
    tr_noop("relabel {take}"),
    tr_noop("exclude {take}"),
    tr_noop("include {take}"),
    tr_noop("delete {take}"),
    tr_noop("restore {take}"),
    tr_noop("Whisper base, multilingual, by OpenAI, MIT licence; {origin}: {path}"),
    tr_noop("chosen"),
    tr_noop("from two packages"),
    tr_noop("in the data of the program"),
    tr_noop("named by {variable}"),
    tr_noop("PhonemeData name: {name}, in bins there, in Hz here"),
    tr_noop("PhonemeData name: {name}"),
    tr_noop("Limit for {variable}; {n} conditions: {phonemes}"),
    tr_noop(
        "Added to the log-odds of {phoneme}: each +1 makes it 2.7 times more likely. The bar shows by how much it "
        "trails the most likely other phoneme; it is recognised while the bar is left of the handle."
    ),
    tr_noop("Background noise recognised as silence: {noise}; speech in the takes: {speech}"),
    tr_noop("Background noise recognised as silence: {noise}"),
    tr_noop("The background noise was as loud as a voice ({db} dBFS); keep quiet and measure it again."),
    tr_noop("A sound stood {db} dB above the background noise; keep quiet and measure it again."),
    tr_noop("The strongest adaptation was rejected, because with it {cost}; a weaker one was chosen."),
    tr_noop("The strongest adaptation was rejected, because with it {cost}; the preset stays unchanged."),
    tr_noop("the recogniser {recogniser} has no other model; choose a preset with a network"),
    tr_noop("{first} and false silence rises from {old} % to {new} %"),
    tr_noop("{first} and silence recall falls from {old} % to {new} %"),
    tr_noop("mouth-shape accuracy falls from {old} % to {new} %"),
    tr_noop("silence recall falls from {old} % to {new} %"),
    tr_noop("false silence rises from {old} % to {new} %"),
    tr_noop("{cost} in the small network"),
    tr_noop("{cost} in the real-time model"),
    tr_noop(
        "No sound was recorded: the loudest part is at {db} dBFS. Check that the microphone is on and say it again, "
        "louder or closer."
    ),
    tr_noop(
        "The recording is clipped: {percent} % of the samples are at full scale. Say it again, a little further from "
        "the microphone, or turn its level down."
    ),
    tr_noop("The sound lasted only {seconds} s; {least} s or more are needed. Say it again and hold it."),
    tr_noop(
        "The sound is {db} dB above the background noise, which is loud ({noise} dBFS); {least} dB or more are "
        "needed. Reduce the noise or move closer to the microphone, and say it again."
    ),
    tr_noop(
        "The sound is {db} dB above the background noise; {least} dB or more are needed. Say it again, louder or "
        "closer to the microphone."
    ),
    tr_noop(
        "The sound reached only {db} dBFS; {least} dBFS or more are needed. Say it again, louder or closer, or turn "
        "the microphone's level up."
    ),
    tr_noop("The silence lasted only {seconds} s; {least} s or more are needed. Keep quiet for longer."),
    tr_noop(
        "There is a sound of {db} dBFS in the silence, whose background noise is at {noise} dBFS. Keep quiet and "
        "record it again."
    ),
    tr_noop("{why}; until then the small network recognises live sound"),
    tr_noop("{why}; until then the small network recognises live sound, and it alone learned the voice."),
    tr_noop("{name}: the speech encoder needs onnxruntime, which is not installed; install phonemeanalyser[encoder]"),
    tr_noop("{name}: this is not a real-time model, or it is damaged; download it again"),
    tr_noop("{name}: the preset was calibrated with another real-time model; calibrate it again"),
    tr_noop("{name}: this is not an audio file that can be read; choose a WAV, AIFF, FLAC, OGG, MP3 or M4A file"),
    tr_noop("{about}, the recording peaks at {peak} dBFS; amplified by {gain} dB for recognition"),
    tr_noop("{about}, its channels cancel each other out when mixed; channel {number} is inverted"),
    tr_noop("{about}, only channel {number} of {n} has a signal and is used"),
    tr_noop("{about}, only the channels {numbers} of {n} have a signal and are mixed"),
    tr_noop("{name}; its channels cancel each other out when mixed, so choose one of them"),
    tr_noop("{name}: the file is truncated after the audio, which is complete"),
    tr_noop("{name}: the header gives no duration; the file contains {there} s"),
    tr_noop("{place} cannot be served ({reason}); choose another host or port"),
    tr_noop("another program uses it"),
    tr_noop("a server needs packages that cannot be loaded ({error}); install them with: {command}"),
    tr_noop("the server has ended by itself"),
    tr_noop("{name}: the file is truncated; its header announces {announced} s, but it contains {there} s"),
    tr_noop("rules need labels of at least two sounds, and the recordings have only {only}; load some with others"),
    tr_noop("a fit needs labels of at least two sounds, and the recordings have only {only}; load some with others"),
    tr_noop("a rule for {label} asks for the variable {variable}, which is not measured; add it, or change the rule"),
    tr_noop("the sensitivity for {label} must lie within ±{most_log_odds}, got {value}; choose another value"),
    tr_noop("nothing that is loaded is clearly labelled {phonemes}; load recordings that have it"),
    tr_noop("{name} reads 0, since the mel filter bank is off; switch Mel on."),
    tr_noop("{name} reads 0, since it begins at {low} Hz and the low-pass ends at {end} Hz; raise the low-pass."),
    tr_noop("{name} reads 0, since it begins at {low} Hz and the spectrum ends at {end} Hz; quantise less."),
    tr_noop("{name} reads 0, since no band lies within {low} to {high} Hz; widen its range."),
    # what a variable measures
    tr_noop("{variable}, filtered"),
    tr_noop("{variable}, raw"),
    tr_noop("{variable}, mel"),
    tr_noop("energy {range} / all"),
    tr_noop("energy {range}"),
    tr_noop("peak {range}"),
    tr_noop("mean {range}"),
    tr_noop("probability of {phoneme}"),
    tr_noop("deficit of {phoneme}"),
)
"""Those with places for what changes; of two that fit, the first one counts."""
_PLACE = re.compile(r"\\\{(\w+)\\\}")
_SOUND = rf"(?:{'|'.join([*SOUNDS, *(phoneme.label for phoneme in Phoneme)])})(?: \d+)?"
_SOUNDS = rf"(?:[<>] )?{_SOUND}(?:, {_SOUND})*…?"
_LIST_OF_SOUNDS = re.compile(rf"{_SOUNDS}(?:; {_SOUNDS})*")


def sound_name(sound: Phoneme | str) -> str:
    """Return what the window calls a phoneme or a mouth shape, which may be given by its label in files."""
    label = sound.label if isinstance(sound, Phoneme) else sound
    return tr(SOUNDS.get(label, label))


def table_title(table: str) -> str:
    """Return what a mouth table is called: by the name that a shipped one has, or its file."""
    return tr(load_table(table).name) if table in shipped_tables() else Path(table).name


def recogniser_title(name: str) -> str:
    """Return what the window calls a recogniser, which is given by its name in files."""
    return RECOGNISERS.get(name, name)


def tr_engine(text: str) -> str:
    """Return what the engine says in the language of the window, as far as it is listed; else as it is."""
    return _in_language(text, language_in_use())


def tr_sentence(text: str) -> str:
    """Return the same where it stands alone: with a capital, where a word begins it rather than a name."""
    told, found = tr_engine(text), _listed(text)
    if found is None or not (found[0].split(" ")[0].isalpha() and tr(found[0])[:1].isalpha()):
        return told
    return told[:1].upper() + told[1:]


@lru_cache(4096)
def _in_language(text: str, _language: str) -> str:
    if _LIST_OF_SOUNDS.fullmatch(text):
        return re.sub(r"[a-z]+", lambda label: sound_name(label[0]), text)
    found = tr(text)
    if found != text:
        return found
    if listed := _listed(text):
        sentence, places = listed
        put_in = tr_engine if sentence in SENTENCES else _of_errors
        put = {k: recogniser_title(v) if k == "recogniser" else put_in(v) for k, v in places.items()}
        return tr(sentence).format(**put)
    bare = text[:1].lower() + text[1:].removesuffix(".")  # as it is where it stands alone
    if bare != text and (told := tr_engine(bare)) != bare:
        return f"{told[:1].upper()}{told[1:]}{text[len(bare) :]}"
    return text


@lru_cache(4096)
def _listed(text: str) -> tuple[str, dict[str, str]] | None:
    """Return which sentence of the engine a text is, and what it has in its places; None for another text."""
    for sentence, start, end in _edges(text[:1]):
        if not (text.startswith(start) and text.endswith(end)):
            continue  # before a pattern is compiled: all of them take a quarter of a second at the start
        if sentence == text:
            return sentence, {}
        if filled := _pattern(sentence).fullmatch(text):
            return sentence, filled.groupdict()
    return None


@cache
def _edges(letter: str) -> tuple[tuple[str, str, str], ...]:
    """Return each sentence that may begin with a letter, with what it begins and ends with."""
    said = (s for s in (*SENTENCES, *ERRORS) if s[0] in (letter, "{"))
    return tuple((s, s.partition("{")[0], s.rpartition("}")[2]) for s in said)


def _of_errors(words: str) -> str:
    """Return what an error has in one of its places: names stay, as they are those of files, columns and keys."""
    return tr_engine(words) if " " in words or words in PARTS else words


@cache
def _pattern(sentence: str) -> re.Pattern[str]:
    """Return what a sentence looks like, with anything in its places, but no file's name amid the first words."""
    places = _PLACE.sub(r"(?P<\1>.*?)", re.escape(sentence))
    return re.compile(re.sub(r"^(\(\?P<\w+>)\.\*\?", r"\1(?:(?!: ).)*?", places), re.DOTALL)
