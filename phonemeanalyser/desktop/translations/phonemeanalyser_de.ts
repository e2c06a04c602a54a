<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
    <context>
        <name>PhonemeAnalyser</name>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source> and </source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/viseme_panel.py" />
            <source> or </source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>&amp;Analysis</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/menus.py" />
            <source>&amp;Edit</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>&amp;File</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>&amp;Help</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>&amp;Labels</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>&amp;Play</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>&amp;Record</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>&amp;Selection</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>&amp;View</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>({n} more are in {folder})</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/variables_panel.py" />
            <source>... from this one, or from all</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>0 at</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>1 at</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_model.py" />
            <source>1 label file for {program} lies beside the takes in {folder}.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>&lt;b&gt;File&lt;/b&gt;</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>&lt;b&gt;Heard&lt;/b&gt;</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>&lt;b&gt;PhonemeAnalyser&lt;/b&gt;&lt;p&gt;Calibrates real-time phoneme recognition for lip sync, and shows why a phoneme was recognised.&lt;p&gt;MIT licence. The demo is a synthetic voice of the Festival project (CMU slt). The head is in the public domain (CC0).&lt;p&gt;&lt;b&gt;The preset Learned.&lt;/b&gt; {notes}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>&lt;b&gt;Recordings&lt;/b&gt;</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/scroll_view.py" />
            <source>&lt;b&gt;Sonagram and phonemes&lt;/b&gt;</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>&lt;b&gt;Takes&lt;/b&gt;</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/record_panel.py" />
            <source>&lt;b&gt;Taking {phoneme}&lt;/b&gt;: let go when it is said</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/scroll_view.py" />
            <source>&lt;b&gt;Variable&lt;/b&gt;</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/welcome.py" />
            <source>&lt;b&gt;What would you like to do first?&lt;/b&gt;</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench_view.py" />
            <source>&lt;b&gt;{truth}&lt;/b&gt; recognised as &lt;b&gt;{answer}&lt;/b&gt;: {n} stretches, {seconds:.2f} s</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recogniser_choice.py" />
            <source>&lt;p&gt;The best that files are heard with. &lt;i&gt;live&lt;/i&gt;: as a microphone. &lt;i&gt;twin&lt;/i&gt;: by a network that hears half a second ahead. &lt;i&gt;Whisper&lt;/i&gt;: with a speech encoder besides, where all of a file is recognised at once: saved, exported or aligned with its text; while it plays, the twin serves.&lt;/p&gt;&lt;p&gt;{without}.&lt;/p&gt;</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recogniser_choice.py" />
            <source>&lt;p&gt;What names the phoneme of each frame. Another one brings the front end and the numbers that it was tuned with, unless you tuned it yourself. What it is tuned by is below.&lt;/p&gt;&lt;p&gt;To add one, install its package beside this program, and start the program again. How to write one is in the README.&lt;/p&gt;</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>A and E</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>a blue line, 0 to 500 Hz from the lower edge to the upper</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/latency_test.py" />
            <source>A click comes back after {ms:.0f} ms ({n_heard} of {n_played} heard, within {spread:.0f} ms of each other); {share}.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/export_queue.py" />
            <source>A clip is seen once it is made; the page Talk shows the same head at once.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/export_kinds.py" />
            <source>a clip of the head</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/export_kinds.py" />
            <source>a clip of the head with its sound</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_panel.py" />
            <source>A file that says how words are pronounced; without one, the voice knows</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>A Folder of Labelled Recordings…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>A folder of sounds</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>A if both, E if the first only</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>A lexicon</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>A mesh, and its movestates</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>A mouth table</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>A phoneme stays so long at least. The bar is how long it has been there.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>A PhonemeData file holds 21 numbers</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/dialogs.py" />
            <source>A preset to compare with</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>a program of your own</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>A recorded expression</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>A small neural network that heard 233 speakers: the surest one, and it adapts to a voice in a minute.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>A step; with Shift a tenth</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>A table of recorded faces</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>a table of recorded faces</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/session.py" />
            <source>a text that a voice speaks</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>A variable of your own</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/welcome.py" />
            <source>A voice plays, and you see what is recognised of it, and why.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>a yellow line, peaks of -80 to 0 dB</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/variable_dialog.py" />
            <source>a-z, 0-9, _, such as my_hiss</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>About PhonemeAnalyser</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/fit_panel.py" />
            <source>accept</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench_view.py" />
            <source>accuracy</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/variables_panel.py" />
            <source>add</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Add Files…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Add Folder…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/variables_panel.py" />
            <source>Add the suggested variable to the preset; Ctrl+Z takes it back</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>added to the log-odds of {phoneme}: each +1 makes it 2.7 times likelier. The bar is by how much it falls short of the likeliest other one: it is named while the bar is left of the handle.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/fit_panel.py" />
            <source>after</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/variable_dialog.py" />
            <source>after all filters</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/variable_dialog.py" />
            <source>after smoothing and pass filters</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>again</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_panel.py" />
            <source>Align</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Align it with the sound</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_model.py" />
            <source>alignment</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>all</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/dialogs.py" />
            <source>All files (*)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>All filters off at once, and back to what they were (B)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>all of these</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>all of these, else it is no silence</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/variables_panel.py" />
            <source>all others</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/choices_panel.py" />
            <source>all phonemes</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/scroll_view.py" />
            <source>All that the microphone heard since Clear, on its own time (Ctrl+B)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectrum_view.py" />
            <source>amplitude</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectrum_view.py" />
            <source>Amplitude axis in dB</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectrum_view.py" />
            <source>Amplitude scale: enlarges small amplitudes, in dB</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>analysis</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_model.py" />
            <source>and {n} more words</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/performance_model.py" />
            <source>and {n} more, below the head</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/compare_panel.py" />
            <source>another file …</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Another phoneme follows only where it is the better one by so much. The bar is by how much it is now.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_model.py" />
            <source>Another text is said in this sound; check the text and its language.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>anti-aliased</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>any</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>any within 15 % of the duration</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Arrows</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>as the format has it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/osc_panel.py" />
            <source>as the head</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>As WAV, with words and phones as a TextGrid beside it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/export_queue.py" />
            <source>at work</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/choices_panel.py" />
            <source>attack</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/times_view.py" />
            <source>attack and release of each sound</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/times_view.py" />
            <source>Attack: until the mouth has gone nine tenths of the way to the sound’s shape. Release: nine tenths of the way back, when silence follows. They stand under [times] in the table: copy one from {tables}, change it, and choose it as your own table.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Audacity label track</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Audacity labels (*.txt)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/waveform_view.py" />
            <source>auto</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>automatic</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>automatic: recorded faces, pinyin, sounds</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Average Its Spectrum</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/averaged_view.py" />
            <source>Averaged spectrum</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Back 1 s</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>Back to what the microphone hears now (Ctrl+B)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Backspace</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>bands</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>Be led through silence and all sounds in under a minute (G)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Becomes</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/fit_panel.py" />
            <source>before</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/variable_dialog.py" />
            <source>before all filters of the spectrum</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport.py" />
            <source>Begin again at the end (L)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>below the first; M if no other</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>beside each sound</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/microphone_bar.py" />
            <source>best rate</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/fit_panel.py" />
            <source>Better on what is loaded, but not on a {left_out} that was left out: load more of them.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/fit_panel.py" />
            <source>Better. The last column leaves each {left_out} out in turn, and fits without it.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/choices_panel.py" />
            <source>blinks</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>Blurs each bin with its neighbours; 1 is the mean of three.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>Blurs each spectrum with the one before; nearer 1 is slower.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_model.py" />
            <source>boundary of a {unit}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>boundary-diphone</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>boundary-triphone</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/scroll_view.py" />
            <source>Brightness in dB, or linear</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>By what the mouth moves where the words are known, of a voice or of a recording</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Bypass All Filters</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>Bypass all filters</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/welcome.py" />
            <source>Calibrate My Voice</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Calm</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Cancel</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/fit_panel.py" />
            <source>cancel</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/export_queue.py" />
            <source>cancelled</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>capture</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/label_tiers.py" />
            <source>change of a label</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>change of notes</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/averages.py" />
            <source>change of the filters</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>change of {what}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>Change the preset, and save it under a name of its own</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>Change the preset; Ctrl+Z takes it back (Return)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>changed</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/preset_box.py" />
            <source>changed since it was saved</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench_view.py" />
            <source>changes a second</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/unsaved.py" />
            <source>changes of the last time</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/figures_table.py" />
            <source>changes per second</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport.py" />
            <source>channel</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport.py" />
            <source>channel of the file</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/microphone_bar.py" />
            <source>channel of the microphone</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/microphone_bar.py" />
            <source>channel {k}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_model.py" />
            <source>check</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>choice among recordings</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/compare_panel.py" />
            <source>choose a preset …</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/take_waveform.py" />
            <source>choose a take to hear and trim it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/encoder_dialog.py" />
            <source>Choose Folder…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/model.py" />
            <source>choose one of {names}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>Choose the folder of the takes, or write labels for other programs beside them</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>Choose the Folder…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Clear</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/figures_table.py" />
            <source>clear vowels right</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench_view.py" />
            <source>Click a cell of the matrix to list what is in it.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/segment_list.py" />
            <source>Click a stretch to hear it, or choose one and press Return</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/timeline.py" />
            <source>Click a stretch to hear it; the wheel scrolls, with Ctrl it zooms</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_panel.py" />
            <source>Click a word to hear it; drag a boundary; the wheel scrolls, with Ctrl it zooms</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_panel.py" />
            <source>Click a word to hear it; the wheel scrolls, with Ctrl it zooms. The times are the voice’s own: to drag boundaries, save the spoken text and open that</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words_view.py" />
            <source>Click to hear and see it as it was recorded, twice for the whole recording</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/level_meter.py" />
            <source>CLIPPED</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>clipped</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/level_meter.py" />
            <source>clipped {seconds:.0f} s ago</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Close</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/fit_panel.py" />
            <source>close</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectrum_view.py" />
            <source>coarse</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Coarse Display</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/waveform_view.py" />
            <source>Coarse display: lowest and highest of eight neighbouring samples</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectrum_view.py" />
            <source>Coarse display: the highest of eight neighbouring bins as one step</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>Colour map</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>colour map</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Comma, full stop</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>Command</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>command</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench_view.py" />
            <source>Compare</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Compare ▾</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/label_dialogs.py" />
            <source>Compared with what is recognised:</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/confusion_view.py" />
            <source>confusion matrix</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>consonant-triphone</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/selection_dialogs.py" />
            <source>Copied {n} frames; a spreadsheet takes them.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/measurement_dialog.py" />
            <source>Copy</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Copy Its Frames as a Table</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/plot_menu.py" />
            <source>Copy Picture</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/measurement_dialog.py" />
            <source>Copy the table, with tabs between the columns</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/plot_menu.py" />
            <source>Copy Values</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Corpus labels (*.csv)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Ctrl+Return</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Ctrl+Shift+Return</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/averaged_view.py" />
            <source>curves</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Curves (*.csv)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>curves for Unity, Godot, pages</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>dark</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>decimation</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/microphone_bar.py" />
            <source>default microphone</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Delete</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>delete</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Delete Label</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Delete the take</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>Delete the take (Delete); Ctrl+Z brings it back</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_model.py" />
            <source>Deleted takes removed from the disk: {n}.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/label_tiers.py" />
            <source>deletion of a label</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>Denoise</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>denoise</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>denoise threshold</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/choices_panel.py" />
            <source>detail</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/compare_panel.py" />
            <source>difference in the matrix</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>diphone</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/banner.py" />
            <source>Dismiss</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/welcome.py" />
            <source>dismiss the cards</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/banner.py" />
            <source>dismiss the message</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>display</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/distribution.py" />
            <source>distribution of the variable</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>Divides each spectrum by its largest amplitude: loudness does not matter.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>done</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/take_waveform.py" />
            <source>Drag the ends of what counts; arrow keys move the beginning by 10 ms, with Shift the end</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head_view.py" />
            <source>Drag to go round the head, with Shift or the right button to move it; turn the wheel to come nearer. By keys: arrows, + and −, Home to go back, W for the wireframe, comma and full stop for the light</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/threshold_view.py" />
            <source>Drag, or arrow keys (with Shift finer).</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Draw the edges of the mesh alone (W)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Drop a sound here, or open one with Ctrl+O</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Drop the range that is marked</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>duration</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/distribution.py" />
            <source>Each row is a sound: histogram, a box from quartile to quartile, the median, and a line from minimum to maximum. Drag a threshold, or move it with the arrow keys (Shift: finer; Up and Down choose one)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recogniser_choice.py" />
            <source>ear for files</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/dialogs.py" />
            <source>Empty deleted takes</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>Empty Deleted Takes…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>end</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>End the guide</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>End the guide; what was recorded stays (Escape)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/record_button.py" />
            <source>End the recording (R)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/fit_panel.py" />
            <source>End the search; the preset stays as it is</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>english</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Esc</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>every</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>every frame of 10 ms with all variables, CSV</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>every frame of 10 ms with all variables, JSON</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>exclude</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Exclude the take, or not</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/take_list.py" />
            <source>excluded</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Export</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Export…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression_panel.py" />
            <source>Expression</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/choices_panel.py" />
            <source>Face</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Factory</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>Fades out from start to end, and removes what lies above.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>Fades the window's ends, so that a tone stays on few bins. Off is a rectangle.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/export_queue.py" />
            <source>failed</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Faster</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/encoder_dialog.py" />
            <source>Fetch It (145 MB)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/encoder_dialog.py" />
            <source>Fetching the model, 145 MB …</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/compare_panel.py" />
            <source>figures</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>file</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recogniser_choice.py" />
            <source>Files</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/encoder_dialog.py" />
            <source>Files are heard best by the network and the encoder of Whisper base together, which knows very many voices. It works on this computer, takes 400 MB of memory, and helps where all of a file is recognised at once: saved, exported, or aligned with its text.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/record_button.py" />
            <source>Fill Gaps with Silence, Besides Marking Them</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>filtered</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Filters</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_panel.py" />
            <source>Find the words of the text in the sound (Ctrl+Shift+Return)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/fit_panel.py" />
            <source>Finds the thresholds that name the most frames right in what is loaded.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/tone_bar.py" />
            <source>First formant</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>First Steps…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>First your room</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench_view.py" />
            <source>Fit</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/fit_panel.py" />
            <source>Fit thresholds</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/record_button.py" />
            <source>FLAC, half the size</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>folder…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>follow</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Follows</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/encoder_dialog.py" />
            <source>Forget the Folder</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>Forget the labelled recordings; their files stay</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Forget the Second</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>formants</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Forward 1 s</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/figures_table.py" />
            <source>frames right, ten sounds</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/state_chips.py" />
            <source>Frames that were analysed but never drawn: the machine has too much to do</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>frames/s</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Freeze Views</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>french</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>freq. smooth</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectrum_view.py" />
            <source>frequency</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/scroll_view.py" />
            <source>frequency (Hz)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>frequency axis</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/tone_bar.py" />
            <source>Frequency of the sine</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/tone_bar.py" />
            <source>Frequency of the sine on a logarithmic scale</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/tone_bar.py" />
            <source>Frequency of the sine: arrow keys by a semitone, page keys by an octave</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>frequency smooth</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/variable_dialog.py" />
            <source>from</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/tone_bar.py" />
            <source>from </source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/segment_list.py" />
            <source>from (s)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>From a sound to its phoneme on the screen, on the average, as measured now: {shares} ms. People notice a picture that is late by more than 45 ms, and stop accepting it at 90 ms (ITU-R BT.1359).</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/state_chips.py" />
            <source>frozen</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Full Screen</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/tone_bar.py" />
            <source>Fundamental of the voice</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>german</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/record_button.py" />
            <source>Go On with the Default Microphone if It Vanishes</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Go on without it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>Go on without this (Right)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Go round; with Shift move it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Goes</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/take_list.py" />
            <source>good</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/sonagram.py" />
            <source>grey</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Guided calibration</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>Guided calibration…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_panel.py" />
            <source>Have a voice say the text (Ctrl+Return); Escape stops it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Head</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/choices_panel.py" />
            <source>head motion</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>Hear the sentence, and see the head with the new preset</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>Hear the sentence, and see the head with the old preset</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Hear with the Second</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Heard with the preset {preset}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/measurement_dialog.py" />
            <source>Heard with the preset {preset}. Pitch and formants are of the frames with a pitch; levels are the root mean square (mean) and the largest sample (max), dB of full scale; phonemes are shares of the frames.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>heard with: {ear}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression_input.py" />
            <source>heard {name}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression_input.py" />
            <source>heard {name} and {n} more</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression_panel.py" />
            <source>held back</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>high pass</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>high pass end</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>high pass start</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>High-pass</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>high-pass end</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>high-pass start</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>hold</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>hold &gt;</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/record_panel.py" />
            <source>Hold a key while its sound is heard</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/record_panel.py" />
            <source>Hold a key, or a button, and say the sound</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Hold a mouth shape</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_model.py" />
            <source>hold the a of “father”</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/record_panel.py" />
            <source>Hold the button, or the key {key}, while you say {name}; or while it is heard in the file that plays</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_model.py" />
            <source>hold the e of “bed”</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/viseme_panel.py" />
            <source>hold the mouth shape {shape}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_model.py" />
            <source>hold the o of “more”</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_model.py" />
            <source>hold the s of “see”</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_model.py" />
            <source>hold the sh of “she”</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_model.py" />
            <source>hold the sound of “food”</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_model.py" />
            <source>hold the sound of “see”</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/viseme_panel.py" />
            <source>Hold this to see the mouth shape {shape}, whatever is said</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/viseme_panel.py" />
            <source>Hold this, or the key {keys}, to see the mouth shape {shape}, whatever is said</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_model.py" />
            <source>Hold {phoneme} for as long as you say the sound: {seconds:.2f} s were heard.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>Holds each phoneme for a least time, and replaces an unidentified one by its likeliest follower. With hysteresis, another phoneme follows only where it is the better one by so much.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Home</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>hop</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression_panel.py" />
            <source>HOST:PORT at which other programs are heard, such as 127.0.0.1:39540</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/osc_panel.py" />
            <source>HOST:PORT of the program that shall receive the mouth, such as 127.0.0.1:39539</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/movestate_bars.py" />
            <source>How far each movestate of the face is on now: of two sides, the left one above and the right one below</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression_panel.py" />
            <source>how far speech holds the expression back</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression_panel.py" />
            <source>How far speech holds the expression back: it goes within 0.1 s and comes back in 0.5 s</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression_panel.py" />
            <source>how far the face shows {name}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/viseme_panel.py" />
            <source>How far the mouth takes the shape {shape}; with all at 0 it is left to the speech</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>How fast a voice of espeak-ng speaks: people say four to five syllables a second</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>How frequencies are spread over the sonagram</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/choices_panel.py" />
            <source>how long every {what} is</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/choices_panel.py" />
            <source>How long every {what} is: 100 % as the table has it, less is faster, more is slower</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>How long the recogniser may wait for what comes after a frame: longer is surer, and later. Rules never wait. With a microphone, waiting makes the mouth late, so it has a limit of its own.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/tone_bar.py" />
            <source>How long the sweep takes</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/take_list.py" />
            <source>How much of it counts, seconds</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression_panel.py" />
            <source>How much of lips and jaw speech has; the expression has the rest. 50 % gives each all that it asks for</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/choices_panel.py" />
            <source>How much of the speech the mouth follows: faces that are far away need less</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/figures_table.py" />
            <source>How often the answer changes: flicker, where labels change less</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/look_ahead_slider.py" />
            <source>how right it is then was not measured</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/export_kinds.py" />
            <source>how right it is, by the labels beside it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_model.py" />
            <source>hum with your lips closed</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>hysteresis</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>hysteresis &gt;</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/tone_bar.py" />
            <source>in </source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/compare_panel.py" />
            <source>in use</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/encoder_dialog.py" />
            <source>In use: {words}.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>include</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Insert Label…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>Intensity</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>intensity high</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>intensity low</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/phoneme_view.py" />
            <source>intensity {intensity:.2f}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/variables_panel.py" />
            <source>It acts once a rule of the preset names it.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>It knows your voice better now</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>It lasted {seconds} s and should last {least} s or more; say it again and hold it.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>It lies {db} dB above the room and should lie {least} dB above it, and the room is loud ({room} dB); make it quieter or come closer to the microphone, and say it again.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>It lies {db} dB above the room and should lie {least} dB above it; say it again, louder or closer to the microphone.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>It reached {db} dB and should reach {least} dB; say it again, louder or closer, or turn the microphone's level up.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>It was too loud for the microphone ({percent}% of the samples are at full scale); say it again, a little further from the microphone, or turn its level down.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/variables_panel.py" />
            <source>it would be measured and drawn, and change no phoneme. The recogniser rules can use them.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>italian</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_model.py" />
            <source>keep quiet</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>keep quiet …</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/room_model.py" />
            <source>Keep quiet: the room is heard for {seconds:g} seconds …</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>keep the old preset</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Keep This One as the Second</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>Keeps every n-th sample. Plain folds high frequencies onto low ones, as the thesis did; anti-aliased removes them first.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Keyboard Shortcuts</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Keyboard shortcuts</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>kind</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/tone_bar.py" />
            <source>Kind of tone</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/dialogs.py" />
            <source>Labelled recordings</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>Labelled recordings beside the takes</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench_view.py" />
            <source>labels</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/label_dialogs.py" />
            <source>Labels (*.TextGrid *.txt *.csv)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>lanes below, where the words are known: words, syllables or letters, phones, units</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Language</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>language of the sentences</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_panel.py" />
            <source>language of the text</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_panel.py" />
            <source>language?</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/scroll_view.py" />
            <source>Largest, mean and smallest value of the variable, over all that was heard since Clear (or since the sound was opened), however long ago; what a seek in a pause only shows does not count</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/look_ahead_slider.py" />
            <source>Late: from a sound to its phoneme on the screen, as this machine measured it since the start, with the microphone that was heard last. Macro F1 and right mouth shapes: of speakers whom the model did not learn from, as its training measured them.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>learning</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>Learning your voice</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/viseme_panel.py" />
            <source>Leave It to the Speech</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/fit_panel.py" />
            <source>Leave the preset as it is</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>Leave the preset as it was; the takes stay (Escape)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport.py" />
            <source>left</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/fit_panel.py" />
            <source>left out</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Left, Right</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>left-half</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Length</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>Let the take count for nothing for now, or count again (X)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words_view.py" />
            <source>letters</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>letters of pinyin</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>level</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/tone_bar.py" />
            <source>level </source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectrum_view.py" />
            <source>level (dB)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/choices_panel.py" />
            <source>level of detail</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/take_list.py" />
            <source>Level of that, dB below full scale (RMS)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/scroll_view.py" />
            <source>level of the brightest colour</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/scroll_view.py" />
            <source>Level of the brightest colour; where brightness is linear, the amplitude of that level</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/scroll_view.py" />
            <source>level of the darkest colour</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/scroll_view.py" />
            <source>Level of the darkest colour; where brightness is linear, the amplitude of that level</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/level_meter.py" />
            <source>level of the microphone</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/tone_bar.py" />
            <source>Level: the highest peak below full scale</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Lexicons (*.toml *.csv)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_panel.py" />
            <source>Lexicon…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/choices_panel.py" />
            <source>Life</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>light</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>linear</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression_panel.py" />
            <source>Listen (OSC) at</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/look_ahead_slider.py" />
            <source>listen to see how late</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport.py" />
            <source>Listen, or let the microphone go</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression_input.py" />
            <source>listening</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Listening for clicks from the loudspeaker, for three seconds …</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>live</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>live look ahead</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>load</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Load a preset or PhonemeData</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Load a preset or PhonemeData file (Ctrl+Shift+O)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Load a second preset</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Load curves</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/averaged_view.py" />
            <source>Load Curve…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>Load labelled recordings: TextGrid, Audacity's labels, CSV</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/label_dialogs.py" />
            <source>Load labels</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Load Labels…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Load Preset…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head_view.py" />
            <source>loading the head …</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>logarithmic</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/distribution.py" />
            <source>logarithmic scale</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/record_button.py" />
            <source>Long Buffer: Blocks of 50 ms, for a Busy Machine</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/microphone_bar.py" />
            <source>Look again which microphones there are (F5)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>look ahead</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Look at the whole head from the front (Home, or a double click)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Look Back</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/scroll_view.py" />
            <source>look back</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Look for Microphones</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/microphone_bar.py" />
            <source>look for microphones again</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>Look-ahead</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>look-ahead</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/encoder_dialog.py" />
            <source>Looking for the model …</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/osc_model.py" />
            <source>looking for the receiver …</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/performance_model.py" />
            <source>looking the face up, {progress:.0%}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Loop</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Loop Selection</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/level_meter.py" />
            <source>loud</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Louder</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/choices_panel.py" />
            <source>loudness only</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>low pass</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>low pass end</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>low pass start</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>Low-pass</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>lower follows faster</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench_view.py" />
            <source>Macro F1 is the mean over the ten sounds. More changes a second than the labels have are flicker</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/look_ahead_slider.py" />
            <source>macro F1 {macro_f1:.2f}, right mouth shapes {percent:.0f} %</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/figures_table.py" />
            <source>macro F1, ten sounds</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>man</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/manual.py" />
            <source>Manual</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/averaged_view.py" />
            <source>Mark a range of frequencies as a variable of your own (V): drag anywhere in the plot</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Mark where a stretch begins, ends</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/record_panel.py" />
            <source>Marked &lt;b&gt;{start} – {end} s&lt;/b&gt;: choose its sound</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/distribution.py" />
            <source>max</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>me</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>mean</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/averaged_view.py" />
            <source>mean of {seconds:.1f} s since {event}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>measure</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Measure Selection</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Measure the Latency by Clicks</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Measure the Room (2 s of Quiet)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>Measure the room: two seconds of quiet set silence and denoising of any recogniser</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>Measured {on_what}.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>measuring its latency</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/compare_panel.py" />
            <source>measuring {percent:.0f} %</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/distribution.py" />
            <source>measuring …</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench_view.py" />
            <source>measuring … {percent:.0f} %</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/distribution.py" />
            <source>median</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/record_button.py" />
            <source>Medium Buffer: Blocks of 20 ms</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>Mel</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>mel</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>mel bands</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Meshes and movestates ({endings})</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/microphone_bar.py" />
            <source>microphone</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/distribution.py" />
            <source>min</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Mine</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>minimum hold</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport.py" />
            <source>mix</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport.py" />
            <source>mono</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Mouth ahead</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>Mouth moves by</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/viseme_panel.py" />
            <source>Mouth shapes</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/figures_table.py" />
            <source>mouth shapes right</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Mouth table</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/choices_panel.py" />
            <source>mouth table</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Mouth tables (*.toml)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/label_tiers.py" />
            <source>move of a boundary</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Move the light</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Move the light to the left (,)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Move the light to the right (.)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Movestates</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/osc_panel.py" />
            <source>movestates that are sent</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/variable_dialog.py" />
            <source>name</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/averaged_view.py" />
            <source>name it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/mapping_dialog.py" />
            <source>Names in the labels</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Nearer, farther</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Network</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression_panel.py" />
            <source>Neutral</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/label_dialogs.py" />
            <source>New label</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/label_tiers.py" />
            <source>new label</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/variable_dialog.py" />
            <source>New variable</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>New Variable…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Next Error</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/level_meter.py" />
            <source>no clipping</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_view.py" />
            <source>no f0</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_view.py" />
            <source>no file</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench_model.py" />
            <source>No frequency range parts these two; record more takes of them, or choose another pair.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/label_dialogs.py" />
            <source>No label is chosen; click one under the sonagram first.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/label_dialogs.py" />
            <source>No labels say what is said; load some by Labels &gt; Load Labels.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_panel.py" />
            <source>No Lexicon</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression_panel.py" />
            <source>No Recording</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/session.py" />
            <source>no sound</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_model.py" />
            <source>No sound was kept before it; go back, and keep quiet for two seconds.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/model.py" />
            <source>No table of the program moves the movestates of this face ({names} …); write a table for them, and load it as your own table.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/dialogs.py" />
            <source>No take is deleted.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/model.py" />
            <source>No take of {phoneme}: {state}; try again when it is heard.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>nobody notices</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_model.py" />
            <source>Nobody says: {words}.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/driver_model.py" />
            <source>Nobody speaks Chinese here, so that there are no letters of pinyin; choose another driver.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/label_dialogs.py" />
            <source>none</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>none loaded</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>none yet: the first take makes one</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>Normalise</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>normalise</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>normalised</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>not listening</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/welcome.py" />
            <source>Not now; the cards are under Help</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/osc_model.py" />
            <source>not reached</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>not silent</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>Not used by the recogniser {name}: it changes only what is seen.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>Not used by {name}: {which}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Notes of the preset {preset}:</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>Nothing better was found</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/fit_panel.py" />
            <source>Nothing better was found than what is in use.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/phoneme_view.py" />
            <source>nothing comes</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>nothing comes from {microphone}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>nothing comes from {microphone} since {seconds} s; trying again every 2 s</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench_view.py" />
            <source>nothing is loaded yet</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>Nothing is recorded, since the latency is being measured; try again in a few seconds.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/selection.py" />
            <source>Nothing is selected; drag with Shift over the file's sonagram, then try again.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Nothing was heard (the loudest part lies at {db} dB); check that the microphone is on and say it again, louder or closer.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_model.py" />
            <source>Nothing was heard that stands out from the room; say it louder or closer.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>Nothing was recorded, since no sound came; check the microphone.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>noticeable</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/averaged_view.py" />
            <source>Now</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>Now this one, to tell what was gained</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>Of several, take</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Of the sound file in hand, as a TextGrid, which exports take</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/choices_panel.py" />
            <source>of the table’s</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/scroll_view.py" />
            <source>of {seconds:.1f} s</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>off</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>on</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_model.py" />
            <source>on one sentence that was held back, {seconds}, labels aligned by the known text</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_model.py" />
            <source>on quarters of what was said, each held back in turn, {seconds:.0f} s</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>One Head</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/compare_panel.py" />
            <source>only the preset in use is right</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_model.py" />
            <source>only the puff of the lips, quickly, with no vowel after it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/compare_panel.py" />
            <source>only the second preset is right</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/compare_panel.py" />
            <source>only the second right</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/compare_panel.py" />
            <source>only the second right: {seconds:.1f} s</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/compare_panel.py" />
            <source>only this right</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/compare_panel.py" />
            <source>only this right: {seconds:.1f} s</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Open a sound file</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport.py" />
            <source>Open a sound file (Ctrl+O)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Open a sound file, and have the head say it at once</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>open a table…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/choices_panel.py" />
            <source>open and shut</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Open It</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Open Recent</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Open Sound…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/session.py" />
            <source>Opening</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/performance_model.py" />
            <source>opening a table …</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/encoder_dialog.py" />
            <source>Opening the model …</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression_input.py" />
            <source>opening …</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Other sounds</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/viseme_panel.py" />
            <source>others and blinks to 0</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/viseme_panel.py" />
            <source>others share 100 %</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/viseme_panel.py" />
            <source>others stay</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/viseme_panel.py" />
            <source>others to 0</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/output_button.py" />
            <source>output device and speed</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>over it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/tone_bar.py" />
            <source>own</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/choices_panel.py" />
            <source>Own Mesh…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/choices_panel.py" />
            <source>own table …</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/manual.py" />
            <source>pages of the manual</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/variables_panel.py" />
            <source>part</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/distribution.py" />
            <source>parts best at {value}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Pause</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/level_meter.py" />
            <source>Peak level in dB below full scale, with the highest of the last 1.5 s, and how the microphone's gain suits it: turn that up where it says soft, down where it says loud. The light tells for a minute that the microphone was too loud</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>Peak levels at which the intensity is 0 and 1; in silence it is 0 at any level.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>phone</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Phoneme</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>PhonemeData name: {name}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>PhonemeData name: {name}, in bins there, in Hz here</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>phonemes as a table</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>phonemes as a TextGrid of Praat</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>phonemes as JSON</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>phonemes as labels of Audacity</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words_view.py" />
            <source>phones</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>pink noise</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>pip install "phonemeanalyser[whisper]" has files heard by one that knows very many voices</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>pitch</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Pixels (*.png);;Lines (*.svg)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>plain</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/session.py" />
            <source>Play</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>play</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Play or Pause</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport.py" />
            <source>Play or pause</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport.py" />
            <source>Play or pause (Space)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Play Selection</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Play the take</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>Play what counts of the take (Return, or a double click)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Praat TextGrid (*.TextGrid)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>pre emphasis</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>Pre-emphasis</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/preset_box.py" />
            <source>Preset</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/preset_box.py" />
            <source>preset</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Preset notes</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Preset Notes…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/compare_panel.py" />
            <source>Preset to compare with, on the same takes and recordings</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>preset {preset}{changed}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>Presets ({endings})</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Press Space to hear the tone</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Press Space to listen, R to record</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Press Space to play</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Preview</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Preview shows what the first, or the chosen, sound becomes.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Previous Error</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression_panel.py" />
            <source>priority of speech</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/choices_panel.py" />
            <source>Program’s Own</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>Quantise</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>quantise</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Quieter</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Quit</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>Raises high frequencies: each sample less a share of the one before it.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/choices_panel.py" />
            <source>randomness</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Rate</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>rate</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>raw</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_model.py" />
            <source>read aloud</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/what_is_this.py" />
            <source>Read on in the manual</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/welcome.py" />
            <source>Read one line aloud: in a minute the program knows your voice.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>Read this as you speak</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/osc_panel.py" />
            <source>receiver of the OSC messages</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Recent</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/timeline.py" />
            <source>recognised</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/confusion_view.py" />
            <source>recognised as →</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recogniser_choice.py" />
            <source>Recogniser</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recogniser_choice.py" />
            <source>recogniser</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>recogniser {name}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Record</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/record_button.py" />
            <source>record</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/record_panel.py" />
            <source>record a take of {name}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Record a take while held</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/fit_model.py" />
            <source>Record takes or load labelled recordings first.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/distribution.py" />
            <source>Record takes, or load labelled recordings, to see how they are spread</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/record_button.py" />
            <source>Record the microphone into {folder} (R)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>Recorded faces</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>recorded faces</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>Recorded faces that say new sentences: `phonemeanalyser performance build` makes one</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Recorded faces, Live Link Face (*.csv)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Recorded {seconds:.1f} s into {path}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/segment_list.py" />
            <source>recording</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Recordings Folder…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/record_button.py" />
            <source>Recordings Go to {folder}…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression_panel.py" />
            <source>Recording…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>red dots, by Burg's method, as Praat measures them</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/menus.py" />
            <source>Redo</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/fit_panel.py" />
            <source>refuse</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/choices_panel.py" />
            <source>release</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>removal of {name}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Remove</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Remove a variable</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Remove Variable…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/averaged_view.py" />
            <source>Remove {name}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/dialogs.py" />
            <source>Remove {what} from the disk for ever? What was done to takes before cannot be undone then.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>Removes what lies below start (hum, rumble), and fades in up to end.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Rename Label…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/label_dialogs.py" />
            <source>Rename the label</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>replace files of others, too</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/threshold_view.py" />
            <source>reset</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Reset Layout</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>reset of {what}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/threshold_view.py" />
            <source>Reset to what the preset's file says</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/plot_menu.py" />
            <source>Reset Zoom</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>reset {text}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>Reset {text} to what the preset's file says</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Return</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>return to the file</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Right</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport.py" />
            <source>right</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>right-half</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/room_model.py" />
            <source>room</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>room noise {decibels:.0f} dB</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/room_model.py" />
            <source>Room of {room}: {sure}; Ctrl+Z takes it back.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Rules of your own over frequency bands: every comparison shows its margin, and every limit can be dragged.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/timeline.py" />
            <source>said</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/timeline.py" />
            <source>said and recognised</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/confusion_view.py" />
            <source>said ↓</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/compare_panel.py" />
            <source>said, not</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/microphone_bar.py" />
            <source>sample rate</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/microphone_bar.py" />
            <source>Sample rate of the microphone; the best is 44 100 Hz where it can do that</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Save as TOML…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/averaged_view.py" />
            <source>Save Curve…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Save Labels</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Save Labels As…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/plot_menu.py" />
            <source>Save Picture…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Save Preset</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Save Preset As…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Save Selection as Sound…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Save the 21 Numbers Only</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Save the averaged spectrum</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/averaged_view.py" />
            <source>Save the averaged spectrum, or load saved ones to compare with</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Save the changes to the preset {preset}?</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/label_dialogs.py" />
            <source>Save the labels</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/label_dialogs.py" />
            <source>Save the labels of {sound}, which you changed?</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Save the phonemes</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Save the Phonemes…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Save the picture</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Save the preset</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/selection_dialogs.py" />
            <source>Save the selected sound</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Save the spoken text</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Save the words</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Save the words of {sound}, whose boundaries you moved?</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/label_dialogs.py" />
            <source>Save what was heard as a sound (Selection &gt; Save Selection as Sound…), open that, and label it.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Save words and phones, or the text as a voice says it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Save ▾</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/label_tiers.py" />
            <source>Saved the labels as {path}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Saved the spoken text as {path}, with words and phones beside it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_model.py" />
            <source>Saved words and phones as {path}.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/selection.py" />
            <source>Saved {seconds:.2f} s of {path} as {target}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_model.py" />
            <source>saving the spoken text …</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_panel.py" />
            <source>Say</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>Say nine single sounds in place of the sentence that is learned from</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Say the sound before once more</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Say the text</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/driver_model.py" />
            <source>Say the text once more: a recorded face is looked up while it is spoken.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>Say this once more (R)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Say this sound once more</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>Say what came before once more (Backspace)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/waveform_view.py" />
            <source>scale</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/manual.py" />
            <source>search</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/variables_panel.py" />
            <source>Search for frequency ranges that part these two best</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/fit_panel.py" />
            <source>Search for thresholds that suit what is loaded, with those in use to begin with</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/manual.py" />
            <source>search the manual</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/fit_panel.py" />
            <source>Searching; you can go on working meanwhile.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/compare_panel.py" />
            <source>second</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/tone_bar.py" />
            <source>Second formant</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Second Preset…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>See the whole file</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>See what is selected (Shift+drag selects)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Seed</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Select All</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>selection</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/osc_panel.py" />
            <source>Send phonemes, mouth shapes and the weights of the movestates over the network, as OSC messages of the VMC protocol, which VTuber programs understand</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/osc_panel.py" />
            <source>Send the mouth (OSC) to</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/osc_model.py" />
            <source>sending, {n} packets</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_model.py" />
            <source>sentence</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/variables_panel.py" />
            <source>separates</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression_panel.py" />
            <source>Set all sliders back to 0</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>Sets amplitudes below the threshold to 0.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>shape</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/choices_panel.py" />
            <source>Shapes and times vary a little, as they do in people</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>share</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/figures_table.py" />
            <source>Share of frames of a, e, i, o and u that are right</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/figures_table.py" />
            <source>Share of frames that are right</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/figures_table.py" />
            <source>Share of frames with the right one of six mouth shapes</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/figures_table.py" />
            <source>Share of silent frames that are called silence</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/figures_table.py" />
            <source>Share of spoken frames that are called silence</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/viseme_panel.py" />
            <source>share of the mouth shape {shape}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/record_button.py" />
            <source>Short Buffer: Blocks of 10 ms, the Least Latency</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Shortest cue</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression_panel.py" />
            <source>Show a face that Live Link Face recorded (CSV) beside the speech, in step with the sound in hand</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/choices_panel.py" />
            <source>Show a mesh of your own (.obj, .glb, .gltf, .x), with its movestates (.3dm)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Show a second head in step, which other means move</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/compare_panel.py" />
            <source>Show in the matrix how much more often the preset in use gives each answer</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/choices_panel.py" />
            <source>Show the head that ships with the program</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression_panel.py" />
            <source>Show what other programs send: /expression NAME 0..1, or the blend shapes of a face tracker (VMC)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/label_dialogs.py" />
            <source>Shown under the sonagram:</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>Shows the spectrum through triangular filters, spaced as the ear hears (HTK mel); variables can measure it.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Silence</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/figures_table.py" />
            <source>silence found</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport.py" />
            <source>Silent</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/output_button.py" />
            <source>silent</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/averaged_view.py" />
            <source>since {event}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>sine</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>single sounds</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>skip ▶</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Sliders and time line</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Slower</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>Smooth F</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>Smooth time</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/level_meter.py" />
            <source>soft</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Something was heard in the silence ({db} dB, where the room has {room} dB); keep quiet and record it again.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/app.py" />
            <source>Something went wrong in the program itself; the details are in {log}.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Sound</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/take_list.py" />
            <source>sound</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>sound of the take</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/mapping_dialog.py" />
            <source>sound of {name}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/variables_panel.py" />
            <source>Sound that is to be told apart</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/state_chips.py" />
            <source>Sound that never came from the microphone, since listening began</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>Sound {index} of {n}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Sounds</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>sounds that are exported</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Sounds to export</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>Sounds with Labels Beside Them…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>sounds, by the mouth table</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport.py" />
            <source>source</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>spanish</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/welcome.py" />
            <source>Speak, and the letters follow; nothing is recorded until you press R.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>Speaker</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/take_list.py" />
            <source>speaker</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Spectra in dB</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/page.py" />
            <source>Spectrum</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/variable_dialog.py" />
            <source>spectrum</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/figures_table.py" />
            <source>speech called silence</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/encoder_dialog.py" />
            <source>Speech Encoder</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Speech Encoder…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression_panel.py" />
            <source>speech priority</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/output_button.py" />
            <source>Speed {percent:.0f} %</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Spoken Text as Sound…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>start</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>State</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>Statistics</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>statistics</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/phoneme_view.py" />
            <source>statistics: {recognised} → {phoneme}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Stop</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Stop (Escape)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport.py" />
            <source>Stop (Escape); a file goes to its beginning</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Stop saying it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/variables_panel.py" />
            <source>stop {percent:.0f} %</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>strength</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench_view.py" />
            <source>Stretches</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench_view.py" />
            <source>stretches of the cell</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/variables_panel.py" />
            <source>suggest</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>sum</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>sweep</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>syllable</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words_view.py" />
            <source>syllables</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>syllables/s</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>system</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>SZ and SCH</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>SZ if both, SCH if the first only</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/choices_panel.py" />
            <source>Table</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>table of recorded faces</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Tables of recorded faces (*.sqlite)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>take</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/take_list.py" />
            <source>takes</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>Takes go into a folder that you may choose</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/session.py" />
            <source>text</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/latency_test.py" />
            <source>the card does not tell which part of it is the microphone's</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/variables_panel.py" />
            <source>The chance that of two frames of different sounds a threshold tells which is which: 50 % says nothing</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>The changes of the preset {name} that were not saved when the program ended are here again.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>The changes that were not saved when the program ended cannot be read: {error}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/microphone_bar.py" />
            <source>The channel that is heard and recorded, or the first two: mixed and recorded as stereo</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>The command that speaks, such as: {example}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/dialogs.py" />
            <source>the deleted take</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>the eyes blink</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/choices_panel.py" />
            <source>The eyes blink at human intervals</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_view.py" />
            <source>the file over time</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/dialogs.py" />
            <source>The folder of the takes</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/encoder_dialog.py" />
            <source>The folder with model.bin and config.json of Whisper base</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head_view.py" />
            <source>the head</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head_view.py" />
            <source>The head cannot be shown: {sentence}.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>the head moves</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/choices_panel.py" />
            <source>The head moves with pitch and loudness of the voice</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>the head or a face of yours</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>The head, when it has the focus</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_model.py" />
            <source>The language of a text is not guessed; choose it below the text.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>The language of the sentences that are read</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_panel.py" />
            <source>The language of the text, which is not guessed</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>the language’s own</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/latency_test.py" />
            <source>The latency was not measured: {why}.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>the likeliest is named</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/record_panel.py" />
            <source>The marked stretch of the file begins where the file stands ([)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/record_panel.py" />
            <source>The marked stretch of the file ends where the file stands (])</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/figures_table.py" />
            <source>The mean F1 of the ten sounds: no figure hides a rare one</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/averaged_view.py" />
            <source>The mean of all spectra that were heard since Play, Record or Clear; when other filters are heard, a new mean begins</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>The microphone changed its form on the way, so what came before that is in {files}.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/session.py" />
            <source>The microphone heard nothing yet; listen to it, then look back.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>The microphone is there: {status}; {lost}.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/microphone_bar.py" />
            <source>The microphone, by name and sound system: {name}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/osc_panel.py" />
            <source>The movestates of the avatar that receives them: those of the head’s table, or another set</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>The nearest of nine mean spectra wins, as in uLipSync; best made from takes of one voice.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/waveform_view.py" />
            <source>The newest window of 46.4 ms, after the filters of the time domain; full scale is ±1</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/manual.py" />
            <source>the page</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>The page Calibrate</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/pages.py" />
            <source>The page {name} (Ctrl+{number})</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/phoneme_view.py" />
            <source>The phoneme now, its intensity, how sure it is (of a hundred answers that are 80 % sure, eighty are right), how often the phoneme changed in the last three seconds, the measures of its window of 46 ms: zc (zero crossings in it), vol (peak level, full scale 1), e (energy: sum of the amplitudes before denoise and normalise), f(g) (fundamental frequency of a voice, 60 to 500 Hz; a higher tone has none), and what each rule said, down to the one that fired</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/phoneme_chip.py" />
            <source>the phoneme that is heard</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/phoneme_chip.py" />
            <source>The phoneme that is heard now, and its intensity</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/phoneme_writer.py" />
            <source>The phonemes of {name} are looked for, and then saved in {target} …</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/phoneme_writer.py" />
            <source>The phonemes of {name} are saved in {target}, heard with: {ear}.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>The program ended while it recorded; {seconds:.1f} s of {begun:%Y-%m-%d, %H:%M} are safe in {path}{others}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/face_model.py" />
            <source>the program's own head</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/variables_panel.py" />
            <source>The recogniser {name} cannot use variables of your own; {why}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/fit_model.py" />
            <source>The recogniser {recogniser} has no thresholds; the guided calibration teaches it your voice.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>the recording waits for it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>the room is not measured yet</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/room_model.py" />
            <source>The room was not heard to the end, since the microphone was let go; measure it again.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>The rules of the thesis as it describes them: weak, but every step shows.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>The rules of the thesis with hysteresis, on sound that quantising does not fold.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>The rules of the thesis with hysteresis: fewer changes.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>The rules of the thesis with the 21 numbers of a PhonemeData file.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>The silence lasted {seconds} s and should last {least} s or more; keep quiet for longer.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>The sonagram after all filters that are on, as recognisers see it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/original_model.py" />
            <source>The sound of {recording} is not beside its table any more, so only its face is shown; put the recordings where they were: {folder}.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/page.py" />
            <source>The spectrum of the newest window of 46.4 ms, after all filters that are on</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_model.py" />
            <source>The stretch of {path} lasts {seconds:.2f} s; mark a longer one.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/output_button.py" />
            <source>the system's output</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>The text below the head</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/unsaved.py" />
            <source>The unsaved changes cannot be kept for the next start: {error}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/scroll_view.py" />
            <source>The variable whose course and extremes are shown</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>The variable whose course is shown</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/waveform_view.py" />
            <source>The vertical scale follows the loudness; the slider beside it ends that</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/state_chips.py" />
            <source>The views stand still while sound goes on; click, or press F, and they go on</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/position_slider.py" />
            <source>The whole file: how loud it is, in the colours of its phonemes (grey where it is not analysed yet). Click to go there; arrow keys go by a second</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>The whole of it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Theme</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/label_dialogs.py" />
            <source>There are no labels yet; load some by Labels &gt; Load Labels.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/label_dialogs.py" />
            <source>There are no labels yet; select a stretch and insert one by Ctrl+I.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_model.py" />
            <source>There are no takes yet whose labels could be written; record one first.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>There are no variables of your own yet; mark a range on the averaged spectrum first.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_model.py" />
            <source>There are no words to save; open a sound and align its text.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>There is no averaged spectrum yet; play a sound first.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/label_dialogs.py" />
            <source>There is no error after this place.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/label_dialogs.py" />
            <source>There is no error before this place.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/model.py" />
            <source>There is no file in hand; open one to mark a stretch of it.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/encoder_dialog.py" />
            <source>there is no model yet: fetch it, or choose the folder of one that you have</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/second_preset.py" />
            <source>There is no second preset yet; choose one by Analysis &gt; Second Preset.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/label_dialogs.py" />
            <source>There is no sound file in hand; open the one that the labels belong to.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>There is no sound file in hand; open the one whose phonemes are to be saved.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_model.py" />
            <source>There is no sound file in hand; open the recording of this text, then align.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_model.py" />
            <source>There is no text; write what is said into the field below the head.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench_model.py" />
            <source>There is nothing to search in yet; record takes or load labelled recordings first.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/mapping_dialog.py" />
            <source>These names stand for no sound that is known here. Say what each one is; what stays unidentified counts neither as right nor as wrong.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/tone_bar.py" />
            <source>Third formant</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>this takes a few seconds</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>those of the nearest duration</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>those that fit and join best (Viterbi)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>threshold</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Thresholds</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/variable_dialog.py" />
            <source>through the mel bank</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/label_dialogs.py" />
            <source>tier that is compared with what is recognised</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/label_dialogs.py" />
            <source>Tiers</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/label_dialogs.py" />
            <source>tiers that are shown</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Tiers…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/take_waveform.py" />
            <source>time (s)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/scroll_view.py" />
            <source>time before now (s)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/waveform_view.py" />
            <source>time in the window</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/position_slider.py" />
            <source>time line</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>time smooth</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/choices_panel.py" />
            <source>Times</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/variable_dialog.py" />
            <source>to</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/tone_bar.py" />
            <source>to </source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>To the Beginning</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>To the End</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/session.py" />
            <source>tone</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>too late</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>too noisy</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>too quiet</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>too short</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Transport</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/take_waveform.py" />
            <source>trim the take</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>Turn the page where what is heard leaves it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recogniser_choice.py" />
            <source>twin</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>twin, {seconds} s each way</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_model.py" />
            <source>two seconds of your room, with nobody speaking</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/threshold_view.py" />
            <source>type a number, or arrow keys</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/menus.py" />
            <source>Undo</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Undo Them</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>unit</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words_view.py" />
            <source>units</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Unsaved changes</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/label_dialogs.py" />
            <source>Unsaved labels</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Unsaved words</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>use and save as…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Use as a Take of</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/welcome.py" />
            <source>Use My Microphone</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Use the new preset</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>use the new preset</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/fit_panel.py" />
            <source>Use what was found; Ctrl+Z takes it back</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/averaged_view.py" />
            <source>variable</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>variable {name}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Variable:</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/variables_panel.py" />
            <source>variables</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/waveform_view.py" />
            <source>vertical scale of the waveform</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/waveform_view.py" />
            <source>Vertical scale: enlarges quiet sound, in dB</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/state_chips.py" />
            <source>views stand still</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>Voice</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>voice</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>Voice &amp;&amp; Face…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>voice by {speaker}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>voice, rate and mouth of a spoken text</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport.py" />
            <source>volume</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/output_button.py" />
            <source>Volume in dB; click for the output device and the speed</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport.py" />
            <source>Volume {volume:.0f} dB</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/tone_bar.py" />
            <source>Vowel</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>vowel</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>vowel-triphone</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport.py" />
            <source>waiting</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>waiting for the first sound from {microphone}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/welcome.py" />
            <source>Watch the Demo</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/record_button.py" />
            <source>WAV, RF64 beyond 4 GB</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/waveform_view.py" />
            <source>Waveform</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>weights of 15 visemes</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>what a sound becomes</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/viseme_panel.py" />
            <source>what becomes of everything else when a slider is pulled</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/viseme_panel.py" />
            <source>What becomes of the speech, of the other shapes and of blinks when a slider asks for a shape: all stay, and movements add up; all but blinks go to 0; blinks as well; or first the speech and then other shapes shrink, so that all are 100 % at most. Keys and buttons set all but blinks to 0 while they are held</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/banner.py" />
            <source>What can be done about it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_model.py" />
            <source>What else was there is kept, such as {name}.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>What is drawn over the sonagram, and below it: formants, pitch, level, words</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/label_dialogs.py" />
            <source>What is said from {start:.3f} to {end:.3f} s:</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/label_dialogs.py" />
            <source>What is said there:</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words_view.py" />
            <source>what is said when</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_panel.py" />
            <source>What is said, or is to be said: Ctrl+Return says it, Ctrl+Shift+Return aligns it with the sound</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>What Is This?</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head_pair.py" />
            <source>what moves the head</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>what moves the mouth</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>what shapes the variables</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>What the chosen take is: choose another sound to relabel it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/measurement_dialog.py" />
            <source>what was measured</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/take_list.py" />
            <source>What was said</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_view.py" />
            <source>Wheel: zoom at the pointer. Drag: scroll. Click: go there. Shift+drag: select. Home, End: the ends.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression_panel.py" />
            <source>where expressions are listened for</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Where recordings go</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Where the new files go</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport.py" />
            <source>Where the sound comes from</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/tone_bar.py" />
            <source>Where the sweep begins</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/tone_bar.py" />
            <source>Where the sweep ends</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/take_list.py" />
            <source>Whether it is good enough to calibrate with</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport.py" />
            <source>Which channel of the file is analysed</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/choices_panel.py" />
            <source>Which mouth shape each phoneme has, and which movestates make it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>Which of several recordings of the same sounds are taken</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Whisper base and network</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>white noise</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/take_list.py" />
            <source>Who said it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>Who says the takes that are recorded from now on</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>Who says the text, how fast, and what moves the mouth (now: {who}; {moved})</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>Who says the text: a voice of espeak-ng, or a text-to-speech program of your own</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>Window</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>window</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>window function</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Wireframe</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>wireframe</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>With a Table of Recorded Faces</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>With Letters of Pinyin</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>With Sounds, by the Mouth Table</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>woman</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>word</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>words</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Words and Phones…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Write a text on the page Talk, and press Ctrl+Return there</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>Write Labels for Audacity (txt)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>Write Labels for Praat (TextGrid)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/model.py" />
            <source>write one for it, as your own table</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/record_button.py" />
            <source>Write the Phonemes Beside It (.csv)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Zoom to Selection</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Zoom to the Whole File</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/averaged_view.py" />
            <source>{cause} at {seconds} s of {sound}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/phoneme_view.py" />
            <source>{changes:.1f} changes/s</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>{first} and {last}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>{first} and {second} differ in {share:.1f} % of what is seen</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words_view.py" />
            <source>{kind} [{names}] of {recording}, {start:.2f} to {end:.2f} s.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/variables_panel.py" />
            <source>{kind} of {low:.0f}–{high:.0f} Hz of the {source} spectrum, separates {separation:.0%}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/face_model.py" />
            <source>{mesh}: this mesh has no movestates; choose its .3dm file together with it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench_view.py" />
            <source>{minutes:.1f} min in {n} recordings</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/look_ahead_slider.py" />
            <source>{ms:.0f} ms ahead</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/look_ahead_slider.py" />
            <source>{ms:.0f} ms late here</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>{ms:.0f} ms late, {judgement}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/latency_test.py" />
            <source>{ms:.0f} ms of it are the microphone's, and the status line now counts with them</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/microphone_bar.py" />
            <source>{name} (not there)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/filter_column.py" />
            <source>{name} hears the bare sound: the filters shape only what is seen</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>{name}, {rate:g} syllables a second</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name}: reading it is not permitted; change its permissions or copy it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name}: the file is empty (0 bytes); copy or record it again</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name}: there are no samples in it; record or export it again</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name}: there is no such file; check its name and folder</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/model.py" />
            <source>{name}: this face has none of the table's movestates; {known}.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name}: this is a folder, not a sound file; choose a file in it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name}: this is not a sound file that can be read; choose a WAV, AIFF, FLAC, OGG or MP3 file</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>{n} by 1 speaker</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_panel.py" />
            <source>{n} by {speakers} speakers</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/session.py" />
            <source>{n} channels</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{n} conditions of the rules for {phonemes} compare {variable} with this</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/dialogs.py" />
            <source>{n} deleted takes</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_model.py" />
            <source>{n} fit badly</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_model.py" />
            <source>{n} fits badly</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/state_chips.py" />
            <source>{n} frames not drawn</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/averaged_view.py" />
            <source>{n} frames{since}; {front_end}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes_model.py" />
            <source>{n} label files for {program} lie beside the takes in {folder}.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/recordings_model.py" />
            <source>{n} labelled recordings were loaded.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/label_dialogs.py" />
            <source>{n} labels</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/label_dialogs.py" />
            <source>{n} points</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/recordings_model.py" />
            <source>{n} sounds were left out; {refusal}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_model.py" />
            <source>{n} word</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_model.py" />
            <source>{n} words</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/voice_panel.py" />
            <source>{output} is the WAV file that it shall write, {text} the text; without {text}, the program reads the text from its standard input. A TextGrid that it writes beside the sound tells the times.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/app.py" />
            <source>{out}: the picture cannot be written; choose another place with -o</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>{path} cannot hold {listed} of this preset. Save all of it as a TOML file?</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression_panel.py" />
            <source>{path} is shown beside the speech; do without it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_panel.py" />
            <source>{path} says how words are pronounced; do without it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>{path}: cannot be written ({fault}); choose another folder</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/scripts.py" />
            <source>{path}: cannot be written ({reason_of}); choose another folder</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/phoneme_view.py" />
            <source>{percent:.0f} % sure</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectrum_view.py" />
            <source>{plot}: amplitude scale</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/look_ahead_slider.py" />
            <source>{recogniser} never waits</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{recogniser}, {ms} ms ahead</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/original_model.py" />
            <source>{recording}, as recorded: {title}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{rest}, only channel {k} of {n} is used</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{rest}, shorter than one window ({ms} ms), so silence surrounds it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{rest}, {n} channels are mixed to one</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{room} of the room is called silence</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{room} of the room is called silence, and {speech} of the speech in the takes</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/confusion_view.py" />
            <source>{said} recognised as {taken}: {count} frames of 10 ms, {share:.1%} of {said}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/text_model.py" />
            <source>{said}; boundaries fixed by the voice</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>{seconds:.1f} s could not be heard</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/state_chips.py" />
            <source>{seconds:.2f} s lost</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/file_panel.py" />
            <source>{share:.1f} % differ</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/label_dialogs.py" />
            <source>{start:.2f} to {end:.2f} s: {said} is said, {recognised} was recognised</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/take_waveform.py" />
            <source>{start:.2f} – {end:.2f} s of {duration:.2f} s</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/measurement_dialog.py" />
            <source>{start:.3f} to {end:.3f} s of {sound}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/export_kinds.py" />
            <source>{target}: cannot be written ({fault}); name another folder</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/export_kinds.py" />
            <source>{target}: the file that is there may be somebody else's; name another folder, or have it replaced</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/export_queue.py" />
            <source>{target}: {n} bytes that are no text</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>{url}: only files on this computer can be opened; save it here first</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/averaged_view.py" />
            <source>Δ is how differently it is shaped from the averaged spectrum, whatever the loudness</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>▶ new preset</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>▶ old preset</source>
            <translation type="unfinished" />
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide_view.py" />
            <source>◀ back</source>
            <translation type="unfinished" />
        </message>
    </context>
</TS>
