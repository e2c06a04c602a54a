"""Sound in, phonemes, intensities and mouth shapes out, every 10 ms: the engine of PhonemeAnalyser.

This is the API; what is rarer is imported from its module. A game plays a file, or listens to a microphone, and asks
whenever it likes; no call waits for sound, and whatever lives is a context manager::

    from phonemeengine import Listener, Sound, load_preset

    preset = load_preset("learned")          # or a file: what a calibration made of it
    with Listener(preset) as voice:          # a microphone; or Sound("line.wav", preset), and .play()
        phoneme, intensity, confidence = voice.poll()    # every 10 or 20 ms

A program with samples of its own pushes them, cut as they come, or asks about a single window::

    analyser = Analyser(preset, rate=48_000, live=True)
    analysis = analyser.push(samples)        # float32 within ±1 or int16; mono, or (n, n_channels)
    analysis.phonemes, analysis.intensities  # one for each 10 ms that are complete
    phoneme, intensity, confidence = recognise_window(samples[:2048], preset)

Bytes of any rate that come over a network are recognised within 60 ms, with their text, if it comes along, aligned::

    speech = IncomingSpeech(preset, StreamFormat(Encoding.S16, 24_000))
    for piece in speech.pieces(data):        # bytes, cut as they come
        speech.push(piece).analysis.phonemes

A face follows the phonemes, and may be looked at whenever a picture is drawn::

    morpher = Morpher(load_table("arkit"), seed=1)
    morpher.add(now, phoneme, intensity)    # seconds, of a clock of yours
    weights = morpher.weights(now)           # 0..1, one for each of morpher.movestates

Who knows more than phonemes tells the phone as well, in the IPA: ``morpher.add(now, phoneme, intensity, "f")``. Of
whole sounds, `transcript_of_utterance` makes what a mouth needs.

Files become mouth cues, or whatever another program reads::

    cues("line.wav", preset)                 # which shape from when to when
    export("line.wav", "line.json", "rhubarb-json", preset)

A thousand hours of them, on all cores or a cluster, none twice::

    convert_all(sounds, "out", "rhubarb-json", preset)

A Chinese text moves a mouth by pinyin, with a voice's times or by a rate::

    performer = Performer(load_table("arkit"))
    performer.play(pinyin_track("你好。").mouth(), start=now)
    weights = performer.at(now).weights      # as above

Movestates (morph targets) move the vertices of a mesh::

    head = load_head()                       # or load_morph_mesh("face.glb")
    states = MovestateSet(head.mesh, head.states)
    states.set_percentage("jawOpen", 60, Mode.INTERACT)
    positions = states.morphed()             # of all vertices

A text is spoken, and it is known what is said when::

    samples, utterance = speak("Good evening.", Voice("en-gb"))
    [(word.text, word.start, word.end) for word in utterance.words]

Recorded faces become a table, in which units of new sentences are looked up by their phones and duration::

    build_table("recordings", "anna.sqlite")      # NAME.wav, NAME.TextGrid, NAME.csv of Live Link Face
    with PerformanceTable.open("anna.sqlite") as table:
        table.nearest(UnitKind.SYLLABLE, ("m", "a"), 0.21, limit=10)

What is said in a sound, with how loud and high that is, is said by such a face::

        track = PerformanceTrack(utterance, transcript, table)
        animation = track.animation(transcript, rate=60)      # or performer.play(track.mouth(), start=now)

A preset learns a voice from labelled recordings of it, and is judged on others::

    result = calibrate(preset, read_recordings("takes"), held_out=read_recordings("sentence.flac"))
    save_preset(result.preset, "my-voice.toml")
    score(result.preset, read_recordings("corpus")).overall.scores.macro_f1

Whatever is refused is an `EngineError` whose text is one sentence for the person at the screen. What happens to
devices, recordings and files is logged below the logger ``phonemeengine``, silently unless a program listens to it.
"""

import logging

import lazy_loader

__version__ = "0.9.0"

# A name is imported when it is first asked for, so that who analyses files does not wait for meshes. The names, their
# modules and their types stand in __init__.pyi alone.
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

logging.getLogger(__name__).addHandler(logging.NullHandler())
