<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
    <context>
        <name>PhonemeAnalyser</name>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source> and </source>
            <translation> und </translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/viseme_panel.py" />
            <source> or </source>
            <translation> oder </translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>&amp;Analysis</source>
            <translation>&amp;Analyse</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/menus.py" />
            <source>&amp;Edit</source>
            <translation>&amp;Bearbeiten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>&amp;File</source>
            <translation>&amp;Datei</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>&amp;Help</source>
            <translation>&amp;Hilfe</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>&amp;Labels</source>
            <translation>Beschri&amp;ftungen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>&amp;Play</source>
            <translation>&amp;Wiedergabe</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>&amp;Record</source>
            <translation>Aufnah&amp;me</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>&amp;Selection</source>
            <translation>A&amp;uswahl</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>&amp;View</source>
            <translation>A&amp;nsicht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>({n} more are in {folder})</source>
            <translation>({n} weitere sind in {folder})</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/variables_panel.py" />
            <source>... from this one, or from all</source>
            <translation>... von diesem oder von allen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>0 at</source>
            <translation>0 bei</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>1 at</source>
            <translation>1 bei</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_model.py" />
            <source>1 label file for {program} lies beside the takes in {folder}.</source>
            <translation>1 Beschriftungsdatei für {program} liegt neben den Takes in {folder}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>&lt;b&gt;File&lt;/b&gt;</source>
            <translation>&lt;b&gt;Datei&lt;/b&gt;</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>&lt;b&gt;Heard&lt;/b&gt;</source>
            <translation>&lt;b&gt;Gehörtes&lt;/b&gt;</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>&lt;b&gt;PhonemeAnalyser&lt;/b&gt;&lt;p&gt;Calibrates real-time phoneme recognition for lip sync, and shows why a phoneme was recognised.&lt;p&gt;Version {version}, MIT licence; &lt;i&gt;Help &amp;gt; Licences&lt;/i&gt; lists all parts. The demo is a synthetic voice of the Festival project (CMU slt). The head is in the public domain (CC0).&lt;p&gt;&lt;b&gt;The preset Learned.&lt;/b&gt; {notes}</source>
            <translation>&lt;b&gt;PhonemeAnalyser&lt;/b&gt;&lt;p&gt;Kalibriert die Phonemerkennung in Echtzeit für Lippensynchronisation und zeigt, warum ein Phonem erkannt wurde.&lt;p&gt;Version {version}, MIT-Lizenz; &lt;i&gt;Hilfe &amp;gt; Lizenzen&lt;/i&gt; nennt alle Teile. Die Demo ist eine künstliche Stimme des Festival-Projekts (CMU slt). Der Kopf ist gemeinfrei (CC0).&lt;p&gt;&lt;b&gt;Das Preset Learned.&lt;/b&gt; {notes}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>&lt;b&gt;Recordings&lt;/b&gt;</source>
            <translation>&lt;b&gt;Aufnahmen&lt;/b&gt;</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/scroll_view.py" />
            <source>&lt;b&gt;Sonagram and phonemes&lt;/b&gt;</source>
            <translation>&lt;b&gt;Sonagramm und Phoneme&lt;/b&gt;</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>&lt;b&gt;Takes&lt;/b&gt;</source>
            <translation>&lt;b&gt;Takes&lt;/b&gt;</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>&lt;b&gt;Taking {phoneme}&lt;/b&gt;: let go when it is said</source>
            <translation>&lt;b&gt;{phoneme} wird aufgenommen&lt;/b&gt;: loslassen, wenn es gesagt ist</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/scroll_view.py" />
            <source>&lt;b&gt;Variable&lt;/b&gt;</source>
            <translation>&lt;b&gt;Variable&lt;/b&gt;</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/welcome.py" />
            <source>&lt;b&gt;What would you like to do first?&lt;/b&gt;</source>
            <translation>&lt;b&gt;Womit soll es losgehen?&lt;/b&gt;</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>&lt;b&gt;{truth}&lt;/b&gt; recognised as &lt;b&gt;{answer}&lt;/b&gt;: {n} stretches, {seconds:.2f} s</source>
            <translation>&lt;b&gt;{truth}&lt;/b&gt; erkannt als &lt;b&gt;{answer}&lt;/b&gt;: {n} Strecken, {seconds:.2f} s</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>&lt;p&gt;Macro F1 is the mean over those of the ten sounds that the labels hold. More changes a second than the labels have are flicker.&lt;/p&gt;&lt;p&gt;Takes and recordings are recognised by the model for live sound, which is what you calibrate; files that you open may have a better one.&lt;/p&gt;</source>
            <translation>&lt;p&gt;Makro-F1 ist das Mittel über die der zehn Laute, die in der Beschriftung vorkommen. Mehr Wechsel pro Sekunde, als die Beschriftung hat, sind Flackern.&lt;/p&gt;&lt;p&gt;Aufnahmen erkennt hier das Modell für Live-Klang, das kalibriert wird; geöffnete Dateien haben vielleicht ein besseres.&lt;/p&gt;</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/recogniser_choice.py" />
            <source>&lt;p&gt;The best that files are heard with. &lt;i&gt;live&lt;/i&gt;: as a microphone. &lt;i&gt;twin&lt;/i&gt;: by a network that hears half a second ahead. &lt;i&gt;Whisper&lt;/i&gt;: with a speech encoder besides, where all of a file is recognised at once: saved, exported or aligned with its text; while it plays, the twin serves.&lt;/p&gt;&lt;p&gt;What is grey is not there; &lt;i&gt;File &amp;gt; Speech Encoder…&lt;/i&gt; gets Whisper.&lt;/p&gt;</source>
            <translation>&lt;p&gt;Das Beste, womit Dateien erkannt werden. &lt;i&gt;live&lt;/i&gt;: wie ein Mikrofon. &lt;i&gt;Zwilling&lt;/i&gt;: von einem Netz, das eine halbe Sekunde vorausblickt. &lt;i&gt;Whisper&lt;/i&gt;: dazu mit einem Sprach-Encoder, wo eine ganze Datei auf einmal erkannt wird: gespeichert, exportiert oder am Text ausgerichtet; beim Abspielen dient der Zwilling.&lt;/p&gt;&lt;p&gt;Graues ist nicht vorhanden; &lt;i&gt;Datei &amp;gt; Sprach-Encoder…&lt;/i&gt; holt Whisper.&lt;/p&gt;</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/recogniser_choice.py" />
            <source>&lt;p&gt;What names the phoneme of each frame. Another one brings the front end and the numbers that it was tuned with, unless you tuned it yourself. What it is tuned by is below.&lt;/p&gt;&lt;p&gt;To add one, install its package beside this program, and start the program again. How to write one is in the README.&lt;/p&gt;</source>
            <translation>&lt;p&gt;Benennt das Phonem jedes Frames. Ein anderer bringt die Filter und Zahlen mit, für die er eingestellt wurde, sofern sie nicht schon geändert wurden. Was sich an ihm einstellen lässt, steht darunter.&lt;/p&gt;&lt;p&gt;Einen weiteren bekommt das Programm, indem sein Paket daneben installiert und das Programm neu gestartet wird. Wie man einen schreibt, steht im README.&lt;/p&gt;</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/recogniser_choice.py" />
            <source>&lt;p&gt;What recognises a microphone. &lt;i&gt;network&lt;/i&gt;: the small network, which costs next to nothing and looks ahead as little as you like. &lt;i&gt;encoder&lt;/i&gt;: the lower layers of a speech encoder, which knows very many voices, together with the network; it looks ahead 20 or 40 ms and takes a few percent of a processor core.&lt;/p&gt;&lt;p&gt;What is grey is not there.&lt;/p&gt;</source>
            <translation>&lt;p&gt;Womit das Mikrofon erkannt wird. &lt;i&gt;Netz&lt;/i&gt;: das kleine Netz, das fast nichts kostet und beliebig wenig vorausschaut. &lt;i&gt;Encoder&lt;/i&gt;: die unteren Schichten eines Sprach-Encoders, der sehr viele Stimmen kennt, zusammen mit dem Netz; er schaut 20 oder 40 ms voraus und braucht wenige Prozent eines Prozessorkerns.&lt;/p&gt;&lt;p&gt;Was grau ist, ist nicht vorhanden.&lt;/p&gt;</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>A and E</source>
            <translation>A und E</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>a blue line, 0 to 500 Hz from the lower edge to the upper</source>
            <translation>eine blaue Linie, 0 bis 500 Hz vom unteren bis zum oberen Rand</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>A click comes back after {ms:.0f} ms ({n_heard} of {n_played} heard, within {spread:.0f} ms of each other); {share}.</source>
            <translation>Ein Klick kommt nach {ms:.0f} ms zurück ({n_heard} von {n_played} gehört, mit {spread:.0f} ms Streuung); {share}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/export_queue.py" />
            <source>A clip is seen once it is made; the page Talk shows the same head at once.</source>
            <translation>Ein Clip ist erst zu sehen, wenn er fertig ist; die Seite Sprechen zeigt denselben Kopf sofort.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/export_kinds.py" />
            <source>a clip of the head</source>
            <translation>ein Clip des Kopfes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/export_kinds.py" />
            <source>a clip of the head with its sound</source>
            <translation>ein Clip des Kopfes mit Ton</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>A file that says how words are pronounced; without one, the voice knows</source>
            <translation>Eine Datei, die sagt, wie Wörter ausgesprochen werden; ohne sie weiß es die Stimme</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/ship_dialog.py" />
            <source>a folder of its own</source>
            <translation>ein eigener Ordner</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>A Folder of Labelled Recordings…</source>
            <translation>Ordner mit beschrifteten Aufnahmen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>A folder of sounds</source>
            <translation>Ein Ordner mit Klängen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>A if both, E if the first only</source>
            <translation>A bei beiden, E bei nur dem ersten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>A lexicon</source>
            <translation>Ein Lexikon</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>A mesh, and its movestates</source>
            <translation>Ein Netz und seine Movestates</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>A mouth table</source>
            <translation>Eine Mundtabelle</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>a package for Unity: C#, a talking face and a talking sprite</source>
            <translation>ein Paket für Unity: C#, ein sprechendes Gesicht und ein sprechendes Sprite</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>A phoneme stays so long at least. The bar is how long it has been there.</source>
            <translation>So lange bleibt ein Phonem mindestens. Der Balken zeigt, wie lange es schon da ist.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>A PhonemeData file holds 21 numbers</source>
            <translation>Eine PhonemeData-Datei fasst 21 Zahlen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/dialogs.py" />
            <source>A preset to compare with</source>
            <translation>Ein Preset zum Vergleichen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>a program of your own</source>
            <translation>ein eigenes Programm</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>A recorded expression</source>
            <translation>Ein aufgezeichneter Ausdruck</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>A small neural network that heard 122 speakers: the surest one, and it adapts to a voice in a minute.</source>
            <translation>Ein kleines neuronales Netz, das 122 Sprecher gehört hat: am sichersten, und in einer Minute an eine Stimme angepasst.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>A step; with Shift a tenth</source>
            <translation>Schritt; mit Umschalt ein Zehntel</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>A table of recorded faces</source>
            <translation>Eine Tabelle aufgezeichneter Gesichter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>a table of recorded faces</source>
            <translation>eine Tabelle aufgezeichneter Gesichter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/sources.py" />
            <source>a text that a voice speaks</source>
            <translation>ein Text, den eine Stimme spricht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>A variable of your own</source>
            <translation>Eine eigene Variable</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/welcome.py" />
            <source>A voice plays, and you see what is recognised of it, and why.</source>
            <translation>Eine Stimme spricht, und es ist zu sehen, was davon erkannt wird und warum.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>a yellow line, peaks of -80 to 0 dB</source>
            <translation>eine gelbe Linie, Spitzen von -80 bis 0 dB</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_dialog.py" />
            <source>a-z, 0-9, _, such as my_hiss</source>
            <translation>a-z, 0-9, _, zum Beispiel mein_zischen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>About PhonemeAnalyser</source>
            <translation>Über PhonemeAnalyser</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>accept</source>
            <translation>annehmen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>accuracy</source>
            <translation>Genauigkeit</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/variables_panel.py" />
            <source>add</source>
            <translation>hinzufügen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Add Files…</source>
            <translation>Dateien hinzufügen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Add Folder…</source>
            <translation>Ordner hinzufügen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/variables_panel.py" />
            <source>Add the suggested variable to the preset; Ctrl+Z takes it back</source>
            <translation>Die vorgeschlagene Variable ins Preset aufnehmen; Strg+Z nimmt es zurück</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>add {take}</source>
            <translation>Hinzufügen von {take}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>added to the log-odds of {phoneme}: each +1 makes it 2.7 times likelier. The bar is by how much it falls short of the likeliest other one: it is named while the bar is left of the handle.</source>
            <translation>wird zur logarithmierten Chance von {phoneme} addiert: Jede +1 macht es 2.7-mal wahrscheinlicher. Der Balken zeigt, wie viel ihm zum wahrscheinlichsten anderen fehlt: Es gilt, solange der Balken links vom Griff endet.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>after</source>
            <translation>nachher</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_dialog.py" />
            <source>after all filters</source>
            <translation>nach allen Filtern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_dialog.py" />
            <source>after smoothing and pass filters</source>
            <translation>nach Glätten und Passfiltern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>again</source>
            <translation>noch einmal</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Albanian</source>
            <translation>Albanisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Align</source>
            <translation>Ausrichten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Align Anyway</source>
            <translation>Trotzdem ausrichten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Align it with the sound</source>
            <translation>Ihn am Klang ausrichten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>aligned words ({n})</source>
            <translation>ausgerichtete Wörter ({n})</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>alignment</source>
            <translation>Ausrichten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>all</source>
            <translation>alles</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/dialogs.py" />
            <source>All files (*)</source>
            <translation>Alle Dateien (*)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>All filters off at once, and back to what they were (B)</source>
            <translation>Alle Filter auf einmal aus, und wieder wie zuvor (B)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>all of these</source>
            <translation>alles davon</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>all of these, else it is no silence</source>
            <translation>alles davon, sonst keine Stille</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/variables_panel.py" />
            <source>all others</source>
            <translation>alle anderen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>all phonemes</source>
            <translation>alle Phoneme</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/scroll_view.py" />
            <source>All that the microphone heard since Clear, on its own time (Ctrl+B)</source>
            <translation>Alles, was das Mikrofon seit dem Leeren gehört hat, auf eigener Zeitachse (Strg+B)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Amharic</source>
            <translation>Amharisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/spectrum_view.py" />
            <source>amplitude</source>
            <translation>Amplitude</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/spectrum_view.py" />
            <source>Amplitude axis in dB</source>
            <translation>Amplitudenachse in dB</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/spectrum_view.py" />
            <source>Amplitude scale: enlarges small amplitudes, in dB</source>
            <translation>Amplitudenmaßstab: vergrößert kleine Amplituden, in dB</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>an add-on for Godot 4 with .NET, with the same two</source>
            <translation>ein Add-on für Godot 4 mit .NET, mit denselben beiden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Analyse</source>
            <translation>Analysieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>analysis</source>
            <translation>Analyse</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>and {n} more words</source>
            <translation>und {n} weitere Wörter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/performance_model.py" />
            <source>and {n} more, below the head</source>
            <translation>und {n} weitere, unter dem Kopf</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>anger</source>
            <translation>Ärger</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>another file …</source>
            <translation>eine andere Datei …</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Another phoneme follows only where it is the better one by so much. The bar is by how much it is now.</source>
            <translation>Ein anderes Phonem folgt nur, wenn es um so viel besser passt. Der Balken zeigt, um wie viel es jetzt ist.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>Another text seems to be said in this sound; check the text and its language, or align anyway.</source>
            <translation>In dieser Aufnahme scheint ein anderer Text gesprochen zu werden; Text und Sprache prüfen oder trotzdem ausrichten.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>anti-aliased</source>
            <translation>ohne Aliasing</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>any</source>
            <translation>beliebige</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>any within 15 % of the duration</source>
            <translation>beliebige innerhalb von 15 % der Dauer</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Arabic</source>
            <translation>Arabisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Aragonese</source>
            <translation>Aragonesisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Armenian (East Armenia)</source>
            <translation>Armenisch (Ostarmenien)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Armenian (West Armenia)</source>
            <translation>Armenisch (Westarmenien)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Arrows</source>
            <translation>Pfeiltasten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>as on Talk</source>
            <translation>wie unter Sprechen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>as on Talk: {name}</source>
            <translation>wie unter Sprechen: {name}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>as the format has it</source>
            <translation>wie im Format üblich</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/osc_model.py" />
            <source>as the head</source>
            <translation>wie der Kopf</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>As WAV, with words and phones as a TextGrid beside it</source>
            <translation>Als WAV, mit Wörtern und Phonen als TextGrid daneben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Assamese</source>
            <translation>Assamesisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/export_queue.py" />
            <source>at work</source>
            <translation>in Arbeit</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>attack</source>
            <translation>Attack</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>attack and release of each sound</source>
            <translation>Attack und Release jedes Lautes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>Attack: until the mouth has gone nine tenths of the way to the sound’s shape. Release: nine tenths of the way back, when silence follows. They stand under [times] in the table: copy one from {tables}, change it, and choose it as your own table.</source>
            <translation>Attack: bis der Mund neun Zehntel des Weges zur Form des Lautes gegangen ist. Release: neun Zehntel des Weges zurück, wenn Stille folgt. Beide stehen unter [times] in der Tabelle: eine aus {tables} kopieren, ändern und als eigene Tabelle wählen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Audacity label track</source>
            <translation>Textspur für Audacity</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Audacity labels (*.txt)</source>
            <translation>Audacity-Beschriftungen (*.txt)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/waveform_view.py" />
            <source>auto</source>
            <translation>auto</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>automatic</source>
            <translation>automatisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>automatic: recorded faces, pinyin, sounds</source>
            <translation>automatisch: Gesichter, Pinyin, Laute</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Average Its Spectrum</source>
            <translation>Ihr Spektrum mitteln</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>Averaged spectrum</source>
            <translation>Gemitteltes Spektrum</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Azerbaijani</source>
            <translation>Aserbaidschanisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Back 1 s</source>
            <translation>1 s zurück</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>Back to what the microphone hears now (Ctrl+B)</source>
            <translation>Zurück zu dem, was das Mikrofon jetzt hört (Strg+B)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Backspace</source>
            <translation>Rücktaste</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>bands</source>
            <translation>Bänder</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Bashkir</source>
            <translation>Baschkirisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Basque</source>
            <translation>Baskisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Be led through silence and all sounds in under a minute (G)</source>
            <translation>In weniger als einer Minute durch Stille und alle Laute führen lassen (G)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Becomes</source>
            <translation>Wird zu</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>before</source>
            <translation>vorher</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_dialog.py" />
            <source>before all filters of the spectrum</source>
            <translation>vor allen Filtern des Spektrums</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Begin again at the end (L)</source>
            <translation>Am Ende von vorn beginnen (L)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Belarusian</source>
            <translation>Belarussisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>below the first; M if no other</source>
            <translation>unter dem ersten; M, wenn sonst nichts</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Bengali</source>
            <translation>Bengalisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>beside each sound</source>
            <translation>neben jeden Klang</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/microphone_bar.py" />
            <source>best rate</source>
            <translation>beste Rate</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Better on what is loaded, but not on a {left_out} that was left out: load more of them.</source>
            <translation>Besser im Geladenen, aber nicht bei dem, was ausgelassen wurde ({left_out}): mehr davon laden.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Better. The last column leaves each {left_out} out in turn, and fits without it.</source>
            <translation>Besser. In der letzten Spalte fehlte beim Anpassen jeweils ein Teil ({left_out}).</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>blinks</source>
            <translation>Blinzeln</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Blurs each bin with its neighbours; 1 is the mean of three.</source>
            <translation>Verwischt jede Frequenzstufe mit ihren Nachbarn; 1 ist das Mittel aus dreien.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Blurs each spectrum with the one before; nearer 1 is slower.</source>
            <translation>Verwischt jedes Spektrum mit dem vorigen; je näher an 1, desto träger.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Bosnian</source>
            <translation>Bosnisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>boundary of a {unit}</source>
            <translation>Verschieben einer Grenze ({unit})</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>boundary-diphone</source>
            <translation>Grenz-Diphon</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>boundary-triphone</source>
            <translation>Grenz-Triphon</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/scroll_view.py" />
            <source>Brightness in dB, or linear</source>
            <translation>Helligkeit in dB oder linear</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Bulgarian</source>
            <translation>Bulgarisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>By what the mouth moves where the words are known, of a voice or of a recording</source>
            <translation>Wonach sich der Mund bewegt, wo die Wörter bekannt sind, ob von einer Stimme oder einer Aufnahme</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Bypass All Filters</source>
            <translation>Alle Filter umgehen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>Bypass all filters</source>
            <translation>Alle Filter umgehen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>C99, for programs of all kinds</source>
            <translation>C99, für Programme aller Art</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Calibrate</source>
            <translation>Kalibrieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/welcome.py" />
            <source>Calibrate My Voice</source>
            <translation>Stimme kalibrieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>calibration</source>
            <translation>Kalibrierung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Calm</source>
            <translation>Ruhe</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Cancel</source>
            <translation>Abbrechen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>cancel</source>
            <translation>abbrechen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/export_queue.py" />
            <source>cancelled</source>
            <translation>abgebrochen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>capture</source>
            <translation>Aufnahme</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Catalan</source>
            <translation>Katalanisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Catalan (Balearic)</source>
            <translation>Katalanisch (Balearen)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Catalan (North-western)</source>
            <translation>Katalanisch (Nordwesten)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Catalan (Valencian)</source>
            <translation>Katalanisch (Valencia)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/label_tiers.py" />
            <source>change of a label</source>
            <translation>Ändern einer Beschriftung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>change of notes</source>
            <translation>Änderung der Notizen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/averages.py" />
            <source>change of the filters</source>
            <translation>Änderung der Filter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>change of {what}</source>
            <translation>Änderung ({what})</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Change the preset, and save it under a name of its own</source>
            <translation>Das Preset ändern und unter eigenem Namen speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Change the preset; Ctrl+Z takes it back (Return)</source>
            <translation>Das Preset ändern; Strg+Z nimmt es zurück (Return)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>changed</source>
            <translation>geändert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>changed on disk</source>
            <translation>auf der Platte geändert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/preset_box.py" />
            <source>changed since it was saved</source>
            <translation>seit dem Speichern geändert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>changes a second</source>
            <translation>Wechsel/s</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/unsaved.py" />
            <source>changes of the last time</source>
            <translation>Änderungen vom letzten Mal</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/figures_table.py" />
            <source>changes per second</source>
            <translation>Wechsel pro Sekunde</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>channel</source>
            <translation>Kanal</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>channel of the file</source>
            <translation>Kanal der Datei</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/microphone_bar.py" />
            <source>channel of the microphone</source>
            <translation>Kanal des Mikrofons</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/microphone_bar.py" />
            <source>channel {k}</source>
            <translation>Kanal {k}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>check</source>
            <translation>Prüfung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Chinese (Cantonese)</source>
            <translation>Chinesisch (Kantonesisch)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Chinese (Mandarin)</source>
            <translation>Chinesisch (Mandarin)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Chinese (Mandarin, Pinyin)</source>
            <translation>Chinesisch (Mandarin, Pinyin)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>choice among recordings</source>
            <translation>Wahl unter Aufzeichnungen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>choose a preset …</source>
            <translation>ein Preset wählen …</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/take_waveform.py" />
            <source>choose a take to hear and trim it</source>
            <translation>einen Take wählen und zuschneiden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/recogniser_choice.py" />
            <source>Choose Folder…</source>
            <translation>Ordner wählen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/model.py" />
            <source>choose one of {names}</source>
            <translation>eine von diesen wählen: {names}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Choose speaker…</source>
            <translation>Sprecher wählen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Choose the folder of the takes, or write labels for other programs beside them</source>
            <translation>Den Ordner der Takes wählen oder Beschriftungen für andere Programme daneben schreiben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Choose the Folder…</source>
            <translation>Ordner wählen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/ship_dialog.py" />
            <source>Choose…</source>
            <translation>Wählen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Chuvash</source>
            <translation>Tschuwaschisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Clear</source>
            <translation>Leeren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/figures_table.py" />
            <source>clear vowels right</source>
            <translation>klare Vokale richtig</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>Click a cell of the matrix to list what is in it.</source>
            <translation>Eine Zelle der Matrix anklicken, um ihren Inhalt aufzulisten.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/figures_table.py" />
            <source>Click a stretch to hear it, or choose one and press Return</source>
            <translation>Eine Strecke anklicken, um sie zu hören, oder eine wählen und Return drücken</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/confusion_view.py" />
            <source>Click a stretch to hear it; the wheel zooms at the pointer, a drag scrolls</source>
            <translation>Klick auf ein Stück spielt es; das Rad zoomt am Mauszeiger, Ziehen rollt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Click a word to hear it; drag a boundary; the wheel zooms at the pointer, a drag scrolls</source>
            <translation>Klick auf ein Wort spielt es; Grenzen lassen sich ziehen; das Rad zoomt am Mauszeiger, Ziehen rollt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Click a word to hear it; the wheel zooms at the pointer, a drag scrolls. The times are the voice’s own: to move boundaries, save the spoken text and open that</source>
            <translation>Klick auf ein Wort spielt es; das Rad zoomt am Mauszeiger, Ziehen rollt. Die Zeiten sind die der Stimme: Um Grenzen zu ziehen, den gesprochenen Text speichern und öffnen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/words_view.py" />
            <source>Click to hear and see it as it was recorded, twice for the whole recording</source>
            <translation>Klicken, um es wie aufgezeichnet zu hören und zu sehen, zweimal für die ganze Aufzeichnung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/level_meter.py" />
            <source>CLIPPED</source>
            <translation>ÜBERSTEUERT</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>clipped</source>
            <translation>übersteuert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/level_meter.py" />
            <source>clipped {seconds:.0f} s ago</source>
            <translation>vor {seconds:.0f} s übersteuert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Close</source>
            <translation>Schließen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>close</source>
            <translation>schließen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/spectrum_view.py" />
            <source>coarse</source>
            <translation>grob</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Coarse Display</source>
            <translation>Grobe Darstellung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/waveform_view.py" />
            <source>Coarse display: lowest and highest of eight neighbouring samples</source>
            <translation>Grobe Darstellung: von je acht benachbarten Abtastwerten der kleinste und der größte</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/spectrum_view.py" />
            <source>Coarse display: the highest of eight neighbouring bins as one step</source>
            <translation>Grobe Darstellung: von je acht benachbarten Frequenzstufen die höchste</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>Colour map</source>
            <translation>Farbtafel</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>colour map</source>
            <translation>Farbtafel</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Comma, full stop</source>
            <translation>Komma, Punkt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Command</source>
            <translation>Befehl</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>command</source>
            <translation>Befehl</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>Compare</source>
            <translation>Vergleichen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Compare ▾</source>
            <translation>Vergleichen ▾</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Compared with what is recognised:</source>
            <translation>Mit dem Erkannten verglichen:</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/confusion_view.py" />
            <source>confusion matrix</source>
            <translation>Verwechslungsmatrix</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>consonant-triphone</source>
            <translation>Konsonanten-Triphon</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/selection_dialogs.py" />
            <source>Copied {n} frames; a spreadsheet takes them.</source>
            <translation>{n} Frames kopiert; eine Tabellenkalkulation nimmt sie an.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/selection_dialogs.py" />
            <source>Copy</source>
            <translation>Kopieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Copy Its Frames as a Table</source>
            <translation>Frames als Tabelle kopieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Copy Picture</source>
            <translation>Bild kopieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/plot_menu.py" />
            <source>Copy Table</source>
            <translation>Tabelle kopieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/selection_dialogs.py" />
            <source>Copy the table, with tabs between the columns</source>
            <translation>Die Tabelle kopieren, mit Tabulatoren zwischen den Spalten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/plot_menu.py" />
            <source>Copy Values</source>
            <translation>Werte kopieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Corpus labels (*.csv)</source>
            <translation>Korpus-Beschriftungen (*.csv)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Count down from two, then keep quiet (Return)</source>
            <translation>Von zwei herunterzählen, dann still sein (Eingabe)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Croatian</source>
            <translation>Kroatisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Ctrl+Return</source>
            <translation>Strg+Return</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Ctrl+Shift+Return</source>
            <translation>Strg+Umschalt+Return</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>curves</source>
            <translation>Kurven</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Curves (*.csv)</source>
            <translation>Kurven (*.csv)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>curves for Unity, Godot, pages</source>
            <translation>Kurven für Unity, Godot, Webseiten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Czech</source>
            <translation>Tschechisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Danish</source>
            <translation>Dänisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>dark</source>
            <translation>dunkel</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Decimation</source>
            <translation>Dezimierung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/microphone_bar.py" />
            <source>default microphone</source>
            <translation>Standardmikrofon</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Delete</source>
            <translation>Entf</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>delete</source>
            <translation>löschen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Delete Label</source>
            <translation>Beschriftung löschen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Delete the chosen takes (Delete); Ctrl+Z brings them back</source>
            <translation>Gewählte Takes löschen (Entf); Strg+Z holt sie zurück</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Delete the take</source>
            <translation>Den Take löschen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_model.py" />
            <source>delete {n} takes</source>
            <translation>{n} Takes löschen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>delete {take}</source>
            <translation>Löschen von {take}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_model.py" />
            <source>Deleted takes removed from the disk: {n}.</source>
            <translation>Gelöschte Takes vom Datenträger entfernt: {n}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/label_tiers.py" />
            <source>deletion of a label</source>
            <translation>Löschen einer Beschriftung</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Denoise</source>
            <translation>Entrauschen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>detail</source>
            <translation>Detail</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>difference in the matrix</source>
            <translation>Unterschied in der Matrix</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>diphone</source>
            <translation>Diphon</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>disgust</source>
            <translation>Ekel</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/banner.py" />
            <source>Dismiss</source>
            <translation>Schließen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/welcome.py" />
            <source>dismiss the cards</source>
            <translation>die Karten schließen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/banner.py" />
            <source>dismiss the message</source>
            <translation>die Meldung schließen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>display</source>
            <translation>Anzeige</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/distribution.py" />
            <source>distribution of the variable</source>
            <translation>Verteilung der Variable</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Divides each spectrum by its largest amplitude: loudness does not matter.</source>
            <translation>Teilt jedes Spektrum durch seine größte Amplitude: Die Lautstärke spielt keine Rolle.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>done</source>
            <translation>fertig</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/export_queue.py" />
            <source>done before</source>
            <translation>schon fertig</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/take_waveform.py" />
            <source>Drag the ends of what counts; arrow keys move the beginning by 10 ms, with Shift the end</source>
            <translation>Die Enden dessen ziehen, was zählt; Pfeiltasten bewegen den Anfang um 10 ms, mit Umschalt das Ende</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/head_view.py" />
            <source>Drag to go round the head, with Shift or the right button to move it; turn the wheel to come nearer. By keys: arrows, + and −, Home to go back, W for the wireframe, comma and full stop for the light</source>
            <translation>Ziehen, um den Kopf herumgehen; mit Umschalt oder der rechten Taste verschieben; am Rad drehen, um näher zu kommen. Mit Tasten: Pfeile, + und −, Pos1 zurück, W für das Drahtgitter, Komma und Punkt für das Licht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/threshold_view.py" />
            <source>Drag, or arrow keys (with Shift finer).</source>
            <translation>Ziehen, oder Pfeiltasten (mit Umschalt feiner).</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/head_pair.py" />
            <source>Draw the edges of the mesh alone (W)</source>
            <translation>Nur die Kanten des Netzes zeichnen (W)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/page.py" />
            <source>Drop a sound here, or open one with Ctrl+O</source>
            <translation>Einen Klang hierher ziehen oder mit Strg+O öffnen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Drop the range that is marked</source>
            <translation>Den Bereich verwerfen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>duration</source>
            <translation>Dauer</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Dutch</source>
            <translation>Niederländisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/distribution.py" />
            <source>Each row is a sound: histogram, a box from quartile to quartile, the median, and a line from minimum to maximum. Drag a threshold, or move it with the arrow keys (Shift: finer; Up and Down choose one)</source>
            <translation>Jede Zeile ist ein Laut: Histogramm, ein Kasten von Quartil zu Quartil, der Median und eine Linie vom kleinsten zum größten Wert. Eine Schwelle ziehen oder mit den Pfeiltasten bewegen (Umschalt: feiner; Hoch und Runter wählen eine)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/recogniser_choice.py" />
            <source>ear for files</source>
            <translation>Ohr für Dateien</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Eleven mouth shapes</source>
            <translation>Elf Mundformen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/dialogs.py" />
            <source>Empty deleted takes</source>
            <translation>Gelöschte Takes entfernen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Empty Deleted Takes…</source>
            <translation>Gelöschte Takes entfernen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/recogniser_choice.py" />
            <source>encoder</source>
            <translation>Encoder</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>encoder and network, {ms} ms ahead</source>
            <translation>Encoder und Netz, {ms} ms voraus</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>End the guide</source>
            <translation>Die Führung beenden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>End the guide, and delete its takes; Ctrl+Z brings them back (Escape)</source>
            <translation>Die Anleitung beenden und ihre Takes löschen; Strg+Z holt sie zurück (Esc)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/microphone_bar.py" />
            <source>End the recording (R)</source>
            <translation>Aufnahme beenden (R)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>End the search; the preset stays as it is</source>
            <translation>Die Suche beenden; das Preset bleibt, wie es ist</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>English</source>
            <translation>Englisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>English (America)</source>
            <translation>Englisch (Amerika)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>English (America, New York City)</source>
            <translation>Englisch (Amerika, New York)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>English (Caribbean)</source>
            <translation>Englisch (Karibik)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>English (Great Britain)</source>
            <translation>Englisch (Großbritannien)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>English (Lancaster)</source>
            <translation>Englisch (Lancaster)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>English (Received Pronunciation)</source>
            <translation>Englisch (Received Pronunciation)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>English (Scotland)</source>
            <translation>Englisch (Schottland)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>English (Shavian alphabet)</source>
            <translation>Englisch (Shaw-Alphabet)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>English (West Midlands)</source>
            <translation>Englisch (West Midlands)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Esc</source>
            <translation>Esc</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Estonian</source>
            <translation>Estnisch</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>every</source>
            <translation>jeder</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>every frame of 10 ms with all variables, CSV</source>
            <translation>jeder Frame von 10 ms mit allen Variablen, CSV</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>every frame of 10 ms with all variables, JSON</source>
            <translation>jeder Frame von 10 ms mit allen Variablen, JSON</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>exclude</source>
            <translation>auslassen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Exclude the take, or not</source>
            <translation>Den Take auslassen, oder nicht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_model.py" />
            <source>exclude {n} takes</source>
            <translation>{n} Takes auslassen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>exclude {take}</source>
            <translation>Auslassen von {take}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/take_list.py" />
            <source>excluded</source>
            <translation>ausgelassen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Export</source>
            <translation>Exportieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Export…</source>
            <translation>Exportieren…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Expression</source>
            <translation>Ausdruck</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Face</source>
            <translation>Gesicht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Factory</source>
            <translation>Mitgeliefert</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Fades out from start to end, and removes what lies above.</source>
            <translation>Blendet vom Anfang bis zum Ende aus und entfernt, was darüber liegt.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Fades the window's ends, so that a tone stays on few bins. Off is a rectangle.</source>
            <translation>Blendet die Enden des Fensters aus, sodass ein Ton auf wenigen Frequenzstufen bleibt. Ohne ist es ein Rechteck.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/export_queue.py" />
            <source>failed</source>
            <translation>gescheitert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Faster</source>
            <translation>Schneller</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>fear</source>
            <translation>Furcht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/recogniser_choice.py" />
            <source>Fetch It (145 MB)</source>
            <translation>Holen (145 MB)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/recogniser_choice.py" />
            <source>Fetching the model, 145 MB …</source>
            <translation>Modell wird geholt, 145 MB …</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>figures</source>
            <translation>Zahlen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/sources.py" />
            <source>file</source>
            <translation>Datei</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/recogniser_choice.py" />
            <source>Files</source>
            <translation>Dateien</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/recogniser_choice.py" />
            <source>Files are heard best by the network and the encoder of Whisper base together, which knows very many voices. It works on this computer, takes 250 MB of memory, and helps where all of a file is recognised at once: saved, exported, or aligned with its text.</source>
            <translation>Am besten werden Dateien vom Netz und dem Encoder von Whisper base gemeinsam erkannt, denn der kennt sehr viele Stimmen. Er arbeitet auf diesem Computer, braucht 250 MB Speicher und hilft dort, wo eine ganze Datei auf einmal erkannt wird: beim Speichern, beim Exportieren und beim Ausrichten an einem Text.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/microphone_bar.py" />
            <source>Fill Gaps with Silence, Besides Marking Them</source>
            <translation>Lücken mit Stille füllen und markieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>filtered</source>
            <translation>gefiltert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>filtered</source>
            <comment>a button</comment>
            <translation>Filter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Filters</source>
            <translation>Filter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>filters</source>
            <translation>Filter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Find the words of the text in the sound (Ctrl+Shift+Return)</source>
            <translation>Die Wörter des Textes im Klang finden (Strg+Umschalt+Return)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Finds the thresholds that name the most frames right in what is loaded.</source>
            <translation>Findet die Schwellen, die im Geladenen die meisten Frames richtig benennen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Finnish</source>
            <translation>Finnisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/tone_bar.py" />
            <source>First formant</source>
            <translation>Erster Formant</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>First Steps…</source>
            <translation>Erste Schritte…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>First your room</source>
            <translation>Zuerst der Raum</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>Fit</source>
            <translation>Anpassen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_model.py" />
            <source>fit</source>
            <translation>Anpassung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Fit thresholds</source>
            <translation>Schwellen anpassen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Five mouth shapes</source>
            <translation>Fünf Mundformen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/microphone_bar.py" />
            <source>FLAC, half the size</source>
            <translation>FLAC, halb so groß</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/ship_dialog.py" />
            <source>Folder</source>
            <translation>Ordner</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>folder…</source>
            <translation>Ordner…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>follow</source>
            <translation>folgen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Follows</source>
            <translation>Folgt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/ship_dialog.py" />
            <source>For</source>
            <translation>Für</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/recogniser_choice.py" />
            <source>Forget the Folder</source>
            <translation>Ordner vergessen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Forget the labelled recordings; their files stay</source>
            <translation>Die beschrifteten Aufnahmen vergessen; ihre Dateien bleiben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Forget the Second</source>
            <translation>Das zweite vergessen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>formants</source>
            <translation>Formanten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_painter.py" />
            <source>Formants: zoom in to {n:.0f} s or less</source>
            <translation>Formanten: auf {n:.0f} s oder weniger zoomen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Forward 1 s</source>
            <translation>1 s vor</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/figures_table.py" />
            <source>frames right, ten sounds</source>
            <translation>Frames richtig, zehn Laute</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>Frames that were analysed but never drawn: the machine has too much to do</source>
            <translation>Frames, die analysiert, aber nie gezeichnet wurden: Der Computer hat zu viel zu tun</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>frames/s</source>
            <translation>Bilder/s</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Freeze Views</source>
            <translation>Ansichten einfrieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>French</source>
            <translation>Französisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>French (Belgium)</source>
            <translation>Französisch (Belgien)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>French (France)</source>
            <translation>Französisch (Frankreich)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>French (Switzerland)</source>
            <translation>Französisch (Schweiz)</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Freq. smoothing</source>
            <translation>F-Glättung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/spectrum_view.py" />
            <source>frequency</source>
            <translation>Frequenz</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/scroll_view.py" />
            <source>frequency (Hz)</source>
            <translation>Frequenz (Hz)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>frequency axis</source>
            <translation>Frequenzachse</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/tone_bar.py" />
            <source>Frequency of the sine</source>
            <translation>Frequenz des Sinustons</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/tone_bar.py" />
            <source>Frequency of the sine on a logarithmic scale</source>
            <translation>Frequenz des Sinustons auf logarithmischer Skala</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/tone_bar.py" />
            <source>Frequency of the sine: arrow keys by a semitone, page keys by an octave</source>
            <translation>Frequenz des Sinustons: Pfeiltasten um einen Halbton, Bildtasten um eine Oktave</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_dialog.py" />
            <source>from</source>
            <translation>von</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/tone_bar.py" />
            <source>from </source>
            <translation>von </translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/figures_table.py" />
            <source>from (s)</source>
            <translation>von (s)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>From a sound to its phoneme on the screen, on the average, as measured now: {shares} ms. People notice a picture that is late by more than 45 ms, and stop accepting it at 90 ms (ITU-R BT.1359).</source>
            <translation>Von einem Laut bis zu seinem Phonem auf dem Bildschirm, im Mittel, jetzt gemessen: {shares} ms. Ein Bild, das um mehr als 45 ms nachhinkt, fällt auf, und ab 90 ms stört es (ITU-R BT.1359).</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>frozen</source>
            <translation>eingefroren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Full Screen</source>
            <translation>Vollbild</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/tone_bar.py" />
            <source>Fundamental of the voice</source>
            <translation>Grundfrequenz der Stimme</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Gaelic (Irish)</source>
            <translation>Gälisch (Irland)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Gaelic (Scottish)</source>
            <translation>Gälisch (Schottland)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Georgian</source>
            <translation>Georgisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>German</source>
            <translation>Deutsch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/microphone_bar.py" />
            <source>Go On with the Default Microphone if It Vanishes</source>
            <translation>Mit dem Standardmikrofon weitermachen, wenn es verschwindet</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Go on without it</source>
            <translation>Ohne ihn weitergehen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Go on without this (Right)</source>
            <translation>Ohne dies weitergehen (Rechts)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Go round; with Shift move it</source>
            <translation>Drehen; mit Umschalt bewegen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Goes</source>
            <translation>Ziel</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>gone from disk</source>
            <translation>von der Platte verschwunden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/take_list.py" />
            <source>good</source>
            <translation>gut</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Greek</source>
            <translation>Griechisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Greek (Ancient)</source>
            <translation>Griechisch (Altgriechisch)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Greenlandic</source>
            <translation>Grönländisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/sonagram.py" />
            <source>grey</source>
            <translation>grau</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Guarani</source>
            <translation>Guaraní</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Guided calibration</source>
            <translation>Geführte Kalibrierung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Guided calibration…</source>
            <translation>Geführte Kalibrierung…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Haitian Creole</source>
            <translation>Haitianisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Hakka Chinese</source>
            <translation>Chinesisch (Hakka)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Have a voice say the text (Ctrl+Return); Escape stops it</source>
            <translation>Den Text von einer Stimme sprechen lassen (Strg+Return); Esc beendet es</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Hawaiian</source>
            <translation>Hawaiianisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Head</source>
            <translation>Kopf</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>head motion</source>
            <translation>Kopfbewegung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Hear the sentence, and see the head with the new preset</source>
            <translation>Den Satz hören und den Kopf mit dem neuen Preset sehen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Hear the sentence, and see the head with the old preset</source>
            <translation>Den Satz hören und den Kopf mit dem alten Preset sehen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Hear with the Second</source>
            <translation>Mit dem zweiten hören</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Heard with</source>
            <translation>Gehört mit</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/selection_dialogs.py" />
            <source>Heard with the preset {preset}. Pitch and formants are of the frames with a pitch; levels are the root mean square (mean) and the largest sample (max), dB of full scale; phonemes are shares of the frames.</source>
            <translation>Erkannt mit dem Preset {preset}. Grundfrequenz und Formanten gelten für die Frames mit Grundfrequenz; Pegel sind der Effektivwert (Mittel) und der größte Abtastwert (Max), dB unter Vollaussteuerung; Phoneme sind Anteile der Frames.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>heard with: {ear}</source>
            <translation>gehört mit: {ear}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_model.py" />
            <source>heard {name}</source>
            <translation>gehört: {name}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_model.py" />
            <source>heard {name} and {n} more</source>
            <translation>gehört: {name} und {n} weitere</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Hebrew</source>
            <translation>Hebräisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>held back</source>
            <translation>gehalten</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>High-pass</source>
            <translation>Hochpass</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>High-pass end</source>
            <translation>Hochpass Ende</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>High-pass start</source>
            <translation>Hochpass Anfang</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>hold</source>
            <translation>Halt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Hold a key while its sound is heard</source>
            <translation>Taste halten, solange der Laut klingt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Hold a key, or a button, and say the sound</source>
            <translation>Taste halten und den Laut sprechen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Hold a mouth shape</source>
            <translation>Eine Mundform halten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>hold the a of “father”</source>
            <translation>das a aus „Vater“ halten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Hold the button, or the key {key}, while you say {name}; or while it is heard in the file that plays</source>
            <translation>Die Schaltfläche oder die Taste {key} halten, solange {name} gesprochen wird; oder solange es in der laufenden Datei zu hören ist</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>hold the e of “bed”</source>
            <translation>das e aus „Bett“ halten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/viseme_panel.py" />
            <source>hold the mouth shape {shape}</source>
            <translation>die Mundform {shape} halten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>hold the o of “more”</source>
            <translation>das o aus „Ofen“ halten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>hold the s of “see”</source>
            <translation>das s aus „Fuß“ halten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>hold the sh of “she”</source>
            <translation>das sch aus „schön“ halten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>hold the sound of “food”</source>
            <translation>den Laut aus „du“ halten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>hold the sound of “see”</source>
            <translation>den Laut aus „sieh“ halten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/viseme_panel.py" />
            <source>Hold this to see the mouth shape {shape}, whatever is said</source>
            <translation>Halten, um die Mundform {shape} zu sehen, was auch gesagt wird</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/viseme_panel.py" />
            <source>Hold this, or the key {keys}, to see the mouth shape {shape}, whatever is said</source>
            <translation>Halten, oder die Taste {keys}, um die Mundform {shape} zu sehen, was auch gesagt wird</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_model.py" />
            <source>Hold {phoneme} for as long as you say the sound: {seconds:.2f} s were heard.</source>
            <translation>{phoneme} halten, solange der Laut gesprochen wird: Zu hören waren {seconds:.2f} s.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Holds each phoneme for a least time, and replaces an unidentified one by its likeliest follower. With hysteresis, another phoneme follows only where it is the better one by so much.</source>
            <translation>Hält jedes Phonem eine Mindestzeit lang und ersetzt ein unbekanntes durch seinen wahrscheinlichsten Nachfolger. Mit Hysterese folgt ein anderes Phonem nur, wenn es um so viel besser passt.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Home</source>
            <translation>Pos1</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>hop</source>
            <translation>Schritt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>HOST:PORT at which other programs are heard, such as 127.0.0.1:39540</source>
            <translation>HOST:PORT, auf dem andere Programme gehört werden, zum Beispiel 127.0.0.1:39540</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>HOST:PORT of the program that shall receive the mouth, such as 127.0.0.1:39539</source>
            <translation>HOST:PORT des Programms, das den Mund empfangen soll, zum Beispiel 127.0.0.1:39539</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/movestate_bars.py" />
            <source>How far each movestate of the face is on now: of two sides, the left one above and the right one below</source>
            <translation>Wie weit jeder Movestate des Gesichts jetzt an ist: von zwei Seiten die linke oben und die rechte unten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>how far speech holds the expression back</source>
            <translation>wie weit die Sprache den Ausdruck zurückhält</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>How far speech holds the expression back: it goes within 0.1 s and comes back in 0.5 s</source>
            <translation>Wie weit die Sprache den Ausdruck zurückhält: Er geht in 0.1 s und kommt in 0.5 s wieder</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>how far the face shows {name}</source>
            <translation>wie weit das Gesicht {name} zeigt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/viseme_panel.py" />
            <source>How far the mouth takes the shape {shape}; with all at 0 it is left to the speech</source>
            <translation>Wie weit der Mund die Form {shape} annimmt; sind alle auf 0, bleibt es der Sprache überlassen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>How fast a voice of espeak-ng speaks: people say four to five syllables a second</source>
            <translation>Wie schnell eine Stimme von espeak-ng spricht: Menschen sprechen vier bis fünf Silben pro Sekunde</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>How frequencies are spread over the sonagram</source>
            <translation>Wie sich die Frequenzen über das Sonagramm verteilen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>How late phonemes are on the screen: it is being measured</source>
            <translation>Wie spät Phoneme auf dem Bildschirm sind: wird gemessen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>how long every {what} is</source>
            <translation>wie lange jedes {what} dauert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>How long every {what} is: 100 % as the table has it, less is faster, more is slower</source>
            <translation>Wie lange jedes {what} dauert: 100 % wie in der Tabelle, weniger ist schneller, mehr langsamer</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>How long the recogniser may wait for what comes after a frame: longer is surer, and later. Rules never wait. With a microphone, waiting makes the mouth late, so it has a limit of its own.</source>
            <translation>Wie lange der Erkenner auf das warten darf, was nach einem Frame kommt: länger ist sicherer und später. Regeln warten nie. Beim Mikrofon verspätet das Warten den Mund, daher gilt dafür eine eigene Grenze.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/tone_bar.py" />
            <source>How long the sweep takes</source>
            <translation>Wie lange der Gleitton dauert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/take_list.py" />
            <source>How much of it counts, seconds</source>
            <translation>Wie viel davon zählt, Sekunden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>How much of lips and jaw speech has; the expression has the rest. 50 % gives each all that it asks for</source>
            <translation>Wie viel von Lippen und Kiefer der Sprache gehört; der Rest gehört dem Ausdruck. Bei 50 % bekommt jeder, was er verlangt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>How much of the speech the mouth follows: faces that are far away need less</source>
            <translation>Wie viel von der Sprache der Mund mitmacht: Ferne Gesichter brauchen weniger</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/figures_table.py" />
            <source>How often the answer changes: flicker, where labels change less</source>
            <translation>Wie oft die Antwort wechselt: Flackern, wo die Beschriftung seltener wechselt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>how right it is then was not measured</source>
            <translation>wie richtig es dann ist, wurde nicht gemessen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/export_kinds.py" />
            <source>how right it is, by the labels beside it</source>
            <translation>wie richtig es ist, nach den Beschriftungen daneben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>hum with your lips closed</source>
            <translation>mit geschlossenen Lippen summen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Hungarian</source>
            <translation>Ungarisch</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Hysteresis</source>
            <translation>Hysterese</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>hysteresis</source>
            <translation>Hysterese</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Icelandic</source>
            <translation>Isländisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/tone_bar.py" />
            <source>in </source>
            <translation>in </translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>In the menus, single letters, Delete, F2 and keys with Shift act on the page Analyse only. Where a list, a number or a text has the focus, letters belong to that: click into a plot to leave it.</source>
            <translation>Einzelne Buchstaben, Entf, F2 und Tasten mit Umschalt aus den Menüs wirken nur auf der Seite Analysieren. Hat eine Liste, eine Zahl oder ein Text den Fokus, gehören Buchstaben dorthin: zum Verlassen in ein Diagramm klicken.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>in use</source>
            <translation>benutzt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/recogniser_choice.py" />
            <source>In use: {words}.</source>
            <translation>In Gebrauch: {words}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>include</source>
            <translation>mitzählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_model.py" />
            <source>include {n} takes</source>
            <translation>{n} Takes wieder zählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>include {take}</source>
            <translation>Mitzählen von {take}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Indonesian</source>
            <translation>Indonesisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Insert Label…</source>
            <translation>Beschriftung einfügen…</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Intensity</source>
            <translation>Intensität</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/phoneme_view.py" />
            <source>intensity {intensity:.2f}</source>
            <translation>Intensität {intensity:.2f}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/variables_panel.py" />
            <source>It acts once a rule of the preset names it.</source>
            <translation>Sie wirkt, sobald eine Regel des Presets sie nennt.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>It knows your voice better now</source>
            <translation>Die Stimme ist jetzt besser bekannt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>It lasted {seconds} s and should last {least} s or more; say it again and hold it.</source>
            <translation>Das dauerte {seconds} s und sollte mindestens {least} s dauern; noch einmal sprechen und halten.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>It lies {db} dB above the room and should lie {least} dB above it, and the room is loud ({room} dB); make it quieter or come closer to the microphone, and say it again.</source>
            <translation>Das liegt {db} dB über dem Raum und sollte {least} dB darüber liegen, und der Raum ist laut ({room} dB); für Ruhe sorgen oder näher ans Mikrofon kommen und noch einmal sprechen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>It lies {db} dB above the room and should lie {least} dB above it; say it again, louder or closer to the microphone.</source>
            <translation>Das liegt {db} dB über dem Raum und sollte {least} dB darüber liegen; noch einmal sprechen, lauter oder näher am Mikrofon.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>It reached {db} dB and should reach {least} dB; say it again, louder or closer, or turn the microphone's level up.</source>
            <translation>Das erreichte {db} dB und sollte {least} dB erreichen; noch einmal sprechen, lauter oder näher, oder den Pegel des Mikrofons anheben.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>It was too loud for the microphone ({percent}% of the samples are at full scale); say it again, a little further from the microphone, or turn its level down.</source>
            <translation>Das war zu laut für das Mikrofon ({percent}% der Abtastwerte sind voll ausgesteuert); noch einmal sprechen, etwas weiter weg, oder den Pegel senken.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/variables_panel.py" />
            <source>it would be measured and drawn, and change no phoneme. The recogniser rules can use them.</source>
            <translation>sie würde gemessen und gezeichnet, änderte aber kein Phonem. Der Erkenner rules kann sie benutzen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Italian</source>
            <translation>Italienisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Japanese</source>
            <translation>Japanisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Kazakh</source>
            <translation>Kasachisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>keep quiet</source>
            <translation>still sein</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Keep quiet for two seconds, then read two lines aloud. Nothing is recorded before you press start.</source>
            <translation>Zwei Sekunden still sein, dann zwei Zeilen vorlesen. Vor „los“ wird nichts aufgenommen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Keep quiet for two seconds, then say nine sounds and read a line aloud. Nothing is recorded before you press start.</source>
            <translation>Zwei Sekunden still sein, dann neun Laute sprechen und eine Zeile vorlesen. Vor „los“ wird nichts aufgenommen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>keep quiet …</source>
            <translation>still sein …</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/room_model.py" />
            <source>Keep quiet: the room is heard for {seconds:g} seconds …</source>
            <translation>Still sein: Der Raum wird {seconds:g} Sekunden lang gehört …</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>keep the old preset</source>
            <translation>altes Preset behalten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Keep This One as the Second</source>
            <translation>Dieses als zweites behalten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Keep, Make Only the Others</source>
            <translation>Behalten, nur die anderen erzeugen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Keeps every n-th sample. Plain folds high frequencies onto low ones, as the thesis did; anti-aliased removes them first.</source>
            <translation>Behält jeden n-ten Abtastwert. „Einfach“ faltet hohe Frequenzen auf tiefe, wie in der Thesis; „ohne Aliasing“ entfernt sie vorher.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Keyboard Shortcuts</source>
            <translation>Tastenkürzel</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Keyboard shortcuts</source>
            <translation>Tastenkürzel</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_dialog.py" />
            <source>kind</source>
            <translation>Art</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/tone_bar.py" />
            <source>Kind of tone</source>
            <translation>Art des Tons</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Klingon</source>
            <translation>Klingonisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Korean</source>
            <translation>Koreanisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Kurdish</source>
            <translation>Kurdisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Kyrgyz</source>
            <translation>Kirgisisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/dialogs.py" />
            <source>Labelled recordings</source>
            <translation>Beschriftete Aufnahmen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Labelled recordings beside the takes</source>
            <translation>Beschriftete Aufnahmen neben den Takes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>labels</source>
            <translation>Beschriftung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Labels (*.TextGrid *.txt *.csv)</source>
            <translation>Beschriftungen (*.TextGrid *.txt *.csv)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>lanes below, where the words are known: words, syllables or letters, phones, units</source>
            <translation>Spuren darunter, wo die Wörter bekannt sind: Wörter, Silben oder Buchstaben, Phone, Einheiten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Language</source>
            <translation>Sprache</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>language of the sentences</source>
            <translation>Sprache der Sätze</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>language of the text</source>
            <translation>Sprache des Textes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>language?</source>
            <translation>Sprache?</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/scroll_view.py" />
            <source>Largest, mean and smallest value of the variable, over all that was heard since Clear (or since the sound was opened), however long ago; what a seek in a pause only shows does not count</source>
            <translation>Größter, mittlerer und kleinster Wert der Variable über alles, was seit dem Leeren (oder Öffnen) gehört wurde, wie lange es auch her ist; was ein Sprung in einer Pause nur zeigt, zählt nicht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>Late: from a sound to its phoneme on the screen, as this machine measured it since the start, with the microphone that was heard last. Macro F1 and right mouth shapes: of speakers whom the model did not learn from, as its training measured them.</source>
            <translation>Verspätung: von einem Laut bis zu seinem Phonem auf dem Bildschirm, seit dem Start auf diesem Computer gemessen, mit dem zuletzt gehörten Mikrofon. Makro-F1 und richtige Mundformen: bei Sprechern, von denen das Modell nicht gelernt hat, wie beim Training gemessen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Latin</source>
            <translation>Latein</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Latvian</source>
            <translation>Lettisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>learning</source>
            <translation>lernt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Learning your voice</source>
            <translation>Die Stimme wird gelernt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/viseme_panel.py" />
            <source>Leave It to the Speech</source>
            <translation>Der Sprache überlassen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Leave the preset as it is</source>
            <translation>Das Preset lassen, wie es ist</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Leave the preset as it was; the takes stay (Escape)</source>
            <translation>Das Preset lassen, wie es war; die Takes bleiben (Esc)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Leave {name}, and record the microphone?</source>
            <translation>{name} verlassen und das Mikrofon aufnehmen?</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>left</source>
            <translation>links</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>left out</source>
            <translation>ausgelassen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Left, Right</source>
            <translation>Links, Rechts</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>left-half</source>
            <translation>linke Hälfte</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Length</source>
            <translation>Länge</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Let the chosen takes count for nothing for now, or count again (X)</source>
            <translation>Gewählte Takes vorerst nicht zählen, oder wieder zählen (X)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/words_view.py" />
            <source>letters</source>
            <translation>Buchstaben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>letters of pinyin</source>
            <translation>Pinyin-Buchstaben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>level</source>
            <translation>Pegel</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/tone_bar.py" />
            <source>level </source>
            <translation>Pegel </translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/spectrum_view.py" />
            <source>level (dB)</source>
            <translation>Pegel (dB)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>level of detail</source>
            <translation>Detailgrad</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Level of intensity 0</source>
            <translation>Pegel der Intensität 0</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Level of intensity 1</source>
            <translation>Pegel der Intensität 1</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/take_list.py" />
            <source>Level of that, dB below full scale (RMS)</source>
            <translation>Pegel davon, dB unter Vollaussteuerung (Effektivwert)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/scroll_view.py" />
            <source>level of the brightest colour</source>
            <translation>Pegel der hellsten Farbe</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/scroll_view.py" />
            <source>Level of the brightest colour; where brightness is linear, the amplitude of that level</source>
            <translation>Pegel der hellsten Farbe; bei linearer Helligkeit die Amplitude dieses Pegels</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/scroll_view.py" />
            <source>level of the darkest colour</source>
            <translation>Pegel der dunkelsten Farbe</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/scroll_view.py" />
            <source>Level of the darkest colour; where brightness is linear, the amplitude of that level</source>
            <translation>Pegel der dunkelsten Farbe; bei linearer Helligkeit die Amplitude dieses Pegels</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/level_meter.py" />
            <source>level of the microphone</source>
            <translation>Pegel des Mikrofons</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/tone_bar.py" />
            <source>Level: the highest peak below full scale</source>
            <translation>Pegel: die höchste Spitze unter Vollaussteuerung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Lexicons (*.toml *.csv)</source>
            <translation>Lexika (*.toml *.csv)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Lexicon…</source>
            <translation>Lexikon…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/manual.py" />
            <source>Licences</source>
            <translation>Lizenzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/manual.py" />
            <source>licences of all parts</source>
            <translation>Lizenzen aller Teile</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>Life</source>
            <translation>Leben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>light</source>
            <translation>hell</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>linear</source>
            <translation>linear</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Listen (OSC) at</source>
            <translation>Hören (OSC) auf</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>listen to see how late</source>
            <translation>zuhören zeigt, wie spät</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Listen, or let the microphone go</source>
            <translation>Zuhören oder das Mikrofon freigeben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_model.py" />
            <source>listening</source>
            <translation>hört zu</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Listening for clicks from the loudspeaker, for three seconds …</source>
            <translation>Es wird drei Sekunden lang auf Klicks aus dem Lautsprecher gehört …</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Literal</source>
            <translation>Wörtlich</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Lithuanian</source>
            <translation>Litauisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>live</source>
            <translation>live</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Live look-ahead</source>
            <translation>Vorausschau live</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>load</source>
            <translation>laden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Load a preset or PhonemeData</source>
            <translation>Preset oder PhonemeData laden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Load a preset or PhonemeData file (Ctrl+Shift+O)</source>
            <translation>Preset oder PhonemeData-Datei laden (Strg+Umschalt+O)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Load a second preset</source>
            <translation>Zweites Preset laden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Load curves</source>
            <translation>Kurven laden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>Load Curve…</source>
            <translation>Kurve laden…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Load labelled recordings: TextGrid, Audacity's labels, CSV</source>
            <translation>Beschriftete Aufnahmen laden: TextGrid, Beschriftungen von Audacity, CSV</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Load labels</source>
            <translation>Beschriftungen laden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Load Labels…</source>
            <translation>Beschriftungen laden…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Load Preset…</source>
            <translation>Preset laden…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/head_view.py" />
            <source>loading the head …</source>
            <translation>Kopf wird geladen …</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>log-odds</source>
            <translation>logarithmierte Chance</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>logarithmic</source>
            <translation>logarithmisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/distribution.py" />
            <source>logarithmic scale</source>
            <translation>logarithmische Skala</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/microphone_bar.py" />
            <source>Long Buffer: Blocks of 50 ms, for a Busy Machine</source>
            <translation>Langer Puffer: Blöcke von 50 ms, für einen ausgelasteten Computer</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/microphone_bar.py" />
            <source>Look again which microphones there are (F5)</source>
            <translation>Erneut nach Mikrofonen suchen (F5)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/head_pair.py" />
            <source>Look at the whole head from the front (Home, or a double click)</source>
            <translation>Den ganzen Kopf von vorn ansehen (Pos1 oder Doppelklick)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Look Back</source>
            <translation>Rückschau</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/scroll_view.py" />
            <source>look back</source>
            <translation>Rückschau</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Look for Microphones</source>
            <translation>Nach Mikrofonen suchen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/microphone_bar.py" />
            <source>look for microphones again</source>
            <translation>erneut nach Mikrofonen suchen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Look-ahead</source>
            <translation>Vorausschau</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>look-ahead</source>
            <translation>Vorausschau</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/recogniser_choice.py" />
            <source>Looking for the model …</source>
            <translation>Modell wird gesucht …</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/osc_model.py" />
            <source>looking for the receiver …</source>
            <translation>sucht den Empfänger …</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/performance_model.py" />
            <source>looking the face up, {progress:.0%}</source>
            <translation>schlägt das Gesicht nach, {progress:.0%}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Loop</source>
            <translation>Schleife</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Loop Selection</source>
            <translation>Auswahl als Schleife</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/level_meter.py" />
            <source>loud</source>
            <translation>laut</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Louder</source>
            <translation>Lauter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>loudness only</source>
            <translation>nur Lautstärke</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Low-pass</source>
            <translation>Tiefpass</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Low-pass end</source>
            <translation>Tiefpass Ende</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Low-pass start</source>
            <translation>Tiefpass Anfang</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>lower follows faster</source>
            <translation>kleiner folgt schneller</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Lule Saami</source>
            <translation>Lulesamisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Luxembourgish</source>
            <translation>Luxemburgisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Macedonian</source>
            <translation>Mazedonisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>macro F1</source>
            <translation>Makro-F1</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/figures_table.py" />
            <source>macro F1, ten sounds</source>
            <translation>Makro-F1, zehn Laute</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Malay</source>
            <translation>Malaiisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Maltese</source>
            <translation>Maltesisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>man</source>
            <translation>Mann</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/manual.py" />
            <source>Manual</source>
            <translation>Handbuch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>Mark a range of frequencies as a variable of your own (V): drag anywhere in the plot</source>
            <translation>Einen Frequenzbereich als eigene Variable markieren (V): im Bild ziehen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Mark where a stretch begins, ends</source>
            <translation>Strecke: Anfang, Ende markieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Marked &lt;b&gt;{start} – {end} s&lt;/b&gt;: choose its sound</source>
            <translation>Markiert: &lt;b&gt;{start} – {end} s&lt;/b&gt;; Laut wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/scroll_view.py" />
            <source>max</source>
            <translation>max</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>me</source>
            <translation>ich</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>mean</source>
            <translation>Mittel</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>mean of {seconds:.1f} s since {event}</source>
            <translation>Mittel über {seconds:.1f} s seit {event}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>measure</source>
            <translation>Maß</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Measure Selection</source>
            <translation>Auswahl messen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Measure the Latency by Clicks</source>
            <translation>Latenz mit Klicks messen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Measure the Room (2 s of Quiet)</source>
            <translation>Raum messen (2 s Ruhe)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Measure the room: two seconds of quiet set silence and denoising of any recogniser</source>
            <translation>Den Raum messen: Zwei Sekunden Ruhe stellen Stille und Entrauschen jedes Erkenners ein</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Measured {on_what}.</source>
            <translation>Gemessen {on_what}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>measuring its latency</source>
            <translation>misst seine Latenz</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>measuring {percent:.0f} %</source>
            <translation>misst {percent:.0f} %</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/distribution.py" />
            <source>measuring …</source>
            <translation>misst …</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>measuring … {percent:.0f} %</source>
            <translation>misst … {percent:.0f} %</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/distribution.py" />
            <source>median</source>
            <translation>Median</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/microphone_bar.py" />
            <source>Medium Buffer: Blocks of 20 ms</source>
            <translation>Mittlerer Puffer: Blöcke von 20 ms</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Mel</source>
            <translation>Mel</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>mel</source>
            <translation>mel</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Meshes and movestates ({endings})</source>
            <translation>Netze und Movestates ({endings})</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/recogniser_choice.py" />
            <source>Microphone</source>
            <translation>Mikrofon</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/microphone_bar.py" />
            <source>microphone</source>
            <translation>Mikrofon</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/scroll_view.py" />
            <source>mid</source>
            <translation>Mittel</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/scroll_view.py" />
            <source>min</source>
            <translation>min</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Mine</source>
            <translation>Eigene</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Minimum hold</source>
            <translation>Mindestdauer</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>mix</source>
            <translation>Mix</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/recogniser_choice.py" />
            <source>model for the microphone</source>
            <translation>Modell für das Mikrofon</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>Model: {ear}</source>
            <translation>Modell: {ear}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>mono</source>
            <translation>mono</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Mouth ahead</source>
            <translation>Mund voraus</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Mouth moves by</source>
            <translation>Mund bewegt durch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/viseme_panel.py" />
            <source>Mouth shapes</source>
            <translation>Mundformen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/figures_table.py" />
            <source>mouth shapes right</source>
            <translation>Mundformen richtig</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Mouth table</source>
            <translation>Mundtabelle</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>mouth table</source>
            <translation>Mundtabelle</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/ship_dialog.py" />
            <source>Mouth tables</source>
            <translation>Mundtabellen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Mouth tables (*.toml)</source>
            <translation>Mundtabellen (*.toml)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/label_tiers.py" />
            <source>move of a boundary</source>
            <translation>Verschieben einer Grenze</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Move the light</source>
            <translation>Das Licht bewegen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/head_pair.py" />
            <source>Move the light to the left (,)</source>
            <translation>Das Licht nach links bewegen (,)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/head_pair.py" />
            <source>Move the light to the right (.)</source>
            <translation>Das Licht nach rechts bewegen (.)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Moved by</source>
            <translation>Bewegt durch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Movestates</source>
            <translation>Movestates</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>movestates that are sent</source>
            <translation>Movestates, die gesendet werden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Myanmar (Burmese)</source>
            <translation>Birmanisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Nahuatl (Classical)</source>
            <translation>Nahuatl (klassisch)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_dialog.py" />
            <source>name</source>
            <translation>Name</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>name it</source>
            <translation>benennen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/dialogs.py" />
            <source>Names in the labels</source>
            <translation>Namen in den Beschriftungen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Nearer, farther</source>
            <translation>Näher, ferner</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Nepali</source>
            <translation>Nepalesisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Network</source>
            <translation>Netzwerk</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/recogniser_choice.py" />
            <source>network</source>
            <translation>Netz</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Neutral</source>
            <translation>Neutral</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>New label</source>
            <translation>Neue Beschriftung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/label_tiers.py" />
            <source>new label</source>
            <translation>Einfügen einer Beschriftung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_dialog.py" />
            <source>New variable</source>
            <translation>Neue Variable</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>New Variable…</source>
            <translation>Neue Variable…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Next Error</source>
            <translation>Nächster Fehler</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>No clear change</source>
            <translation>Keine klare Änderung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/level_meter.py" />
            <source>no clipping</source>
            <translation>nicht übersteuert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>no expression</source>
            <translation>kein Ausdruck</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_view.py" />
            <source>no f0</source>
            <translation>keine f0</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_painter.py" />
            <source>no file</source>
            <translation>keine Datei</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_model.py" />
            <source>No frequency range parts these two; record more takes of them, or choose another pair.</source>
            <translation>Kein Frequenzbereich trennt diese beiden; mehr Takes von ihnen aufnehmen oder ein anderes Paar wählen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>No label is chosen; click one under the sonagram first.</source>
            <translation>Keine Beschriftung ist gewählt; zuerst eine unter dem Sonagramm anklicken.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>No labels say what is said; load some by Labels &gt; Load Labels.</source>
            <translation>Keine Beschriftung sagt, was gesprochen wird; welche laden mit Beschriftungen &gt; Beschriftungen laden.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>No Lexicon</source>
            <translation>Kein Lexikon</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>No Recording</source>
            <translation>Keine Aufzeichnung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/sources.py" />
            <source>no sound</source>
            <translation>kein Klang</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>no sound card: silent, on the clock</source>
            <translation>keine Soundkarte: stumm, nach der Uhr</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>No sound was kept before it; go back, and keep quiet for two seconds.</source>
            <translation>Davor wurde kein Laut behalten; zurückgehen und zwei Sekunden still sein.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/model.py" />
            <source>No table of the program moves the movestates of this face ({names} …); write a table for them, and load it as your own table.</source>
            <translation>Keine Tabelle des Programms bewegt die Movestates dieses Gesichts ({names} …); eine Tabelle dafür schreiben und als eigene laden.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/dialogs.py" />
            <source>No take is deleted.</source>
            <translation>Es ist kein Take gelöscht.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/model.py" />
            <source>No take of {phoneme}: {state}; try again when it is heard.</source>
            <translation>Kein Take von {phoneme}: {state}; noch einmal versuchen, wenn es zu hören ist.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>nobody notices</source>
            <translation>unmerklich</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>Nobody says: {words}.</source>
            <translation>Niemand sagt: {words}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/driver_model.py" />
            <source>Nobody speaks Chinese here, so that there are no letters of pinyin; choose another driver.</source>
            <translation>Hier spricht niemand Chinesisch, also gibt es keine Pinyin-Buchstaben; einen anderen Antrieb wählen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Nogai</source>
            <translation>Nogaisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>none</source>
            <translation>keine</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>none loaded</source>
            <translation>keine geladen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>none yet: the first take makes one</source>
            <translation>entsteht mit dem ersten Take</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Normalise</source>
            <translation>Normieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>normalised</source>
            <translation>normiert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Norwegian Bokmål</source>
            <translation>Norwegisch (Bokmål)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>not listening</source>
            <translation>hört nicht zu</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/welcome.py" />
            <source>Not now; the cards are under Help</source>
            <translation>Nicht jetzt; die Karten sind unter Hilfe</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/osc_model.py" />
            <source>not reached</source>
            <translation>nicht erreicht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>not silent</source>
            <translation>nicht still</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>Not used by the recogniser {name}: it changes only what is seen.</source>
            <translation>Vom Erkenner {name} nicht benutzt: ändert nur, was zu sehen ist.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>Not used by {name}: {which}</source>
            <translation>Von {name} nicht benutzt: {which}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Notes of the preset {preset}:</source>
            <translation>Notizen zum Preset {preset}:</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Nothing better was found</source>
            <translation>Es wurde nichts Besseres gefunden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Nothing better was found than what is in use.</source>
            <translation>Es wurde nichts Besseres gefunden als das Benutzte.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/phoneme_view.py" />
            <source>nothing comes</source>
            <translation>es kommt nichts</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>nothing comes from {microphone}</source>
            <translation>von {microphone} kommt nichts</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>nothing comes from {microphone} since {seconds} s; trying again every 2 s</source>
            <translation>von {microphone} kommt seit {seconds} s nichts; alle 2 s ein neuer Versuch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/plot.py" />
            <source>nothing heard yet: play, or click into the sound</source>
            <translation>noch nichts gehört: abspielen, oder in den Klang klicken</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>nothing is loaded yet</source>
            <translation>noch nichts geladen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>Nothing is recorded, since the latency is being measured; try again in a few seconds.</source>
            <translation>Es wird nichts aufgenommen, da gerade die Latenz gemessen wird; in einigen Sekunden noch einmal versuchen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/selection.py" />
            <source>Nothing is selected; drag with Shift over the file's sonagram, then try again.</source>
            <translation>Nichts ist ausgewählt; mit Umschalt über das Sonagramm der Datei ziehen und noch einmal versuchen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Nothing was heard (the loudest part lies at {db} dB); check that the microphone is on and say it again, louder or closer.</source>
            <translation>Es war nichts zu hören (die lauteste Stelle liegt bei {db} dB); prüfen, ob das Mikrofon an ist, und noch einmal sprechen, lauter oder näher.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>Nothing was heard that stands out from the room; say it louder or closer.</source>
            <translation>Es war nichts zu hören, das sich vom Raum abhebt; lauter oder näher sprechen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>Nothing was recorded, since no sound came; check the microphone.</source>
            <translation>Es wurde nichts aufgenommen, da kein Klang kam; das Mikrofon prüfen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>noticeable</source>
            <translation>merklich</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>Now</source>
            <translation>Jetzt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Now this one, to tell what was gained</source>
            <translation>Nun dies, um zu sehen, was gewonnen ist</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Of several, take</source>
            <translation>Von mehreren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Of the sound file in hand, as a TextGrid, which exports take</source>
            <translation>Der geöffneten Klangdatei, als TextGrid, das Exporte übernehmen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>of the table’s</source>
            <translation>der Tabelle</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/scroll_view.py" />
            <source>of {seconds:.1f} s</source>
            <translation>über {seconds:.1f} s</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>off</source>
            <translation>aus</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>on</source>
            <translation>ein</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>on one sentence that was held back, {seconds}, labels aligned by the known text</source>
            <translation>an einem zurückgehaltenen Satz, {seconds}, Beschriftung nach dem bekannten Text ausgerichtet</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>on quarters of what was said, each held back in turn, {seconds:.0f} s</source>
            <translation>an Vierteln des Gesagten, reihum zurückgehalten, {seconds:.0f} s</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>One Head</source>
            <translation>Ein Kopf</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>only the preset in use is right</source>
            <translation>nur das benutzte Preset hat recht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>only the puff of the lips, quickly, with no vowel after it</source>
            <translation>nur das Platzen der Lippen, rasch, ohne Vokal danach</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>only the second preset is right</source>
            <translation>nur das zweite Preset hat recht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>only the second right</source>
            <translation>nur das zweite richtig</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>only the second right: {seconds:.1f} s</source>
            <translation>nur das zweite richtig: {seconds:.1f} s</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>only this right</source>
            <translation>nur dieses richtig</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>only this right: {seconds:.1f} s</source>
            <translation>nur dieses richtig: {seconds:.1f} s</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>only {n} of {n_played} clicks were heard; turn the loudspeaker up, or move the microphone</source>
            <translation>nur {n} von {n_played} Klicks waren zu hören; den Lautsprecher lauter stellen oder das Mikrofon bewegen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Open a sound file</source>
            <translation>Klangdatei öffnen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Open a sound file (Ctrl+O)</source>
            <translation>Klangdatei öffnen (Strg+O)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Open a sound file, and have the head say it at once</source>
            <translation>Eine Klangdatei öffnen und sofort vom Kopf sprechen lassen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>open a table…</source>
            <translation>Tabelle öffnen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>open and shut</source>
            <translation>auf und zu</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Open Folder</source>
            <translation>Ordner öffnen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Open It</source>
            <translation>Öffnen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Open Recent</source>
            <translation>Zuletzt geöffnet</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Open Sound…</source>
            <translation>Klang öffnen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Open the words of the sound: a text, a TextGrid, or JSON with times of words</source>
            <translation>Den Text der Aufnahme öffnen: Textdatei, TextGrid oder JSON mit Wortzeiten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/session.py" />
            <source>Opening</source>
            <translation>Öffnen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/performance_model.py" />
            <source>opening a table …</source>
            <translation>Tabelle wird geöffnet …</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>opening the microphone</source>
            <translation>das Mikrofon wird geöffnet</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/recogniser_choice.py" />
            <source>Opening the model …</source>
            <translation>Modell wird geöffnet …</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_model.py" />
            <source>opening …</source>
            <translation>wird geöffnet …</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Other sounds</source>
            <translation>Andere Laute</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/viseme_panel.py" />
            <source>others and blinks to 0</source>
            <translation>andere und Blinzeln auf 0</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/viseme_panel.py" />
            <source>others share 100 %</source>
            <translation>andere teilen 100 %</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/viseme_panel.py" />
            <source>others stay</source>
            <translation>andere bleiben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/viseme_panel.py" />
            <source>others to 0</source>
            <translation>andere auf 0</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>output device and speed</source>
            <translation>Ausgabegerät und Tempo</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>over it</source>
            <translation>darüber</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/tone_bar.py" />
            <source>own</source>
            <translation>eigene</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>Own Mesh…</source>
            <translation>Eigenes Netz…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>own table …</source>
            <translation>eigene Tabelle …</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>pages of the comparison</source>
            <translation>Seiten des Vergleichs</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/manual.py" />
            <source>pages of the manual</source>
            <translation>Seiten des Handbuchs</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>pages of the workbench</source>
            <translation>Seiten der Werkbank</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/variables_panel.py" />
            <source>part</source>
            <translation>trenne</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/distribution.py" />
            <source>parts best at {value}</source>
            <translation>trennt am besten bei {value}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Pause</source>
            <translation>Pause</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/level_meter.py" />
            <source>Peak level in dB below full scale, with the highest of the last 1.5 s, and how the microphone's gain suits it: turn that up where it says soft, down where it says loud. The light tells for a minute that the microphone was too loud</source>
            <translation>Spitzenpegel in dB unter Vollaussteuerung, mit dem höchsten der letzten 1.5 s, und wie die Verstärkung des Mikrofons dazu passt: höher drehen, wo „leise“ steht, und herunter, wo „laut“ steht. Das Licht meldet eine Minute lang, dass das Mikrofon übersteuert war</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Peak levels at which the intensity is 0 and 1; in silence it is 0 at any level.</source>
            <translation>Spitzenpegel, bei denen die Intensität 0 und 1 ist; bei Stille ist sie immer 0.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>per window</source>
            <translation>je Fenster</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Perhaps edited by hand, or made with other settings.</source>
            <translation>Vielleicht von Hand geändert oder mit anderen Einstellungen erstellt.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Persian</source>
            <translation>Persisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Persian (Pinglish)</source>
            <translation>Persisch (Pinglisch)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>phone</source>
            <translation>Phon</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Phoneme</source>
            <translation>Phonem</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>PhonemeData name: {name}</source>
            <translation>Name in PhonemeData: {name}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>PhonemeData name: {name}, in bins there, in Hz here</source>
            <translation>Name in PhonemeData: {name}, dort in Frequenzstufen, hier in Hz</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>phonemes as a table</source>
            <translation>Phoneme als Tabelle</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>phonemes as a TextGrid of Praat</source>
            <translation>Phoneme als TextGrid von Praat</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>phonemes as JSON</source>
            <translation>Phoneme als JSON</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>phonemes as labels of Audacity</source>
            <translation>Phoneme als Beschriftung von Audacity</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/words_view.py" />
            <source>phones</source>
            <translation>Phone</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>pink noise</source>
            <translation>rosa Rauschen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>pitch</source>
            <translation>Grundfrequenz</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Pixels (*.png);;Lines (*.svg)</source>
            <translation>Pixel (*.png);;Linien (*.svg)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>plain</source>
            <translation>einfach</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/session.py" />
            <source>Play</source>
            <translation>Abspielen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>play</source>
            <translation>anhören</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Play or Pause</source>
            <translation>Abspielen, anhalten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Play or pause</source>
            <translation>Abspielen oder anhalten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Play or pause (Space)</source>
            <translation>Abspielen oder anhalten (Leertaste)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Play Selection</source>
            <translation>Auswahl abspielen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Play the take</source>
            <translation>Den Take anhören</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Play what counts of the take (Return, or a double click)</source>
            <translation>Anhören, was vom Take zählt (Return oder Doppelklick)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Polish</source>
            <translation>Polnisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Portuguese (Brazil)</source>
            <translation>Portugiesisch (Brasilien)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Portuguese (Portugal)</source>
            <translation>Portugiesisch (Portugal)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Praat TextGrid (*.TextGrid)</source>
            <translation>Praat-TextGrid (*.TextGrid)</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Pre-emphasis</source>
            <translation>Preemphase</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/preset_box.py" />
            <source>Preset</source>
            <translation>Preset</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/preset_box.py" />
            <source>preset</source>
            <translation>Preset</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Preset notes</source>
            <translation>Notizen zum Preset</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Preset Notes…</source>
            <translation>Notizen zum Preset…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Preset to compare with, on the same takes and recordings</source>
            <translation>Preset zum Vergleichen, auf denselben Takes und Aufnahmen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>preset {preset}{changed}</source>
            <translation>Preset {preset}{changed}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>Presets ({endings})</source>
            <translation>Presets ({endings})</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/sources.py" />
            <source>Press Space to hear the tone</source>
            <translation>Leertaste drücken, um den Ton zu hören</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/sources.py" />
            <source>Press Space to listen, R to record</source>
            <translation>Leertaste drücken, um zuzuhören, R, um aufzunehmen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/sources.py" />
            <source>Press Space to play</source>
            <translation>Leertaste drücken, um abzuspielen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Preview</source>
            <translation>Vorschau</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Preview shows what the first, or the chosen, sound becomes.</source>
            <translation>Die Vorschau zeigt, was aus dem ersten oder dem gewählten Klang wird.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Previous Error</source>
            <translation>Voriger Fehler</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>priority of speech</source>
            <translation>Vorrang der Sprache</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>Program’s Own</source>
            <translation>Mitgelieferter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Punjabi</source>
            <translation>Panjabi</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Quantise</source>
            <translation>Quantisieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Quieter</source>
            <translation>Leiser</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Quit</source>
            <translation>Beenden</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Raises high frequencies: each sample less a share of the one before it.</source>
            <translation>Hebt hohe Frequenzen an: jeder Abtastwert abzüglich eines Anteils des vorigen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>randomness</source>
            <translation>Zufall</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Rate</source>
            <translation>Rate</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Rate</source>
            <comment>of speech</comment>
            <translation>Tempo</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>rate</source>
            <translation>Tempo</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>ratio</source>
            <translation>Verhältnis</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>raw</source>
            <translation>roh</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>read aloud</source>
            <translation>vorlesen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/what_is_this.py" />
            <source>Read on in the manual</source>
            <translation>Im Handbuch weiterlesen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/welcome.py" />
            <source>Read one line aloud: in a minute the program knows your voice.</source>
            <translation>Eine Zeile vorlesen: In einer Minute kennt das Programm die Stimme.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Read this as you speak</source>
            <translation>Dies natürlich vorlesen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Ready?</source>
            <translation>Bereit?</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>ready?</source>
            <translation>bereit?</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>receiver of the OSC messages</source>
            <translation>Empfänger der OSC-Nachrichten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Recent</source>
            <translation>Zuletzt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/confusion_view.py" />
            <source>recognised</source>
            <translation>erkannt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/confusion_view.py" />
            <source>recognised as →</source>
            <translation>erkannt als →</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/recogniser_choice.py" />
            <source>Recogniser</source>
            <translation>Erkenner</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/recogniser_choice.py" />
            <source>recogniser</source>
            <translation>Erkenner</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>recogniser {name}</source>
            <translation>Erkenner {name}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>recognition only</source>
            <translation>nur Erkennung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Record</source>
            <translation>Aufnehmen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/microphone_bar.py" />
            <source>record</source>
            <translation>aufnehmen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>record a take of {name}</source>
            <translation>einen Take von {name} aufnehmen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Record a take while held</source>
            <translation>Take aufnehmen, solange gehalten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_model.py" />
            <source>Record takes or load labelled recordings first.</source>
            <translation>Zuerst Takes aufnehmen oder beschriftete Aufnahmen laden.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/distribution.py" />
            <source>Record takes, or load labelled recordings, to see how they are spread</source>
            <translation>Verteilungen erscheinen mit Takes oder Aufnahmen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/microphone_bar.py" />
            <source>Record the microphone into {folder} (R)</source>
            <translation>Das Mikrofon nach {folder} aufnehmen (R)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Recorded faces</source>
            <translation>Aufgezeichnetes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>recorded faces</source>
            <translation>aufgezeichnete Gesichter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Recorded faces that say new sentences: `phonemeanalyser performance build` makes one</source>
            <translation>Aufgezeichnete Gesichter, die neue Sätze sprechen: `phonemeanalyser performance build` macht eine</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Recorded faces, Live Link Face (*.csv)</source>
            <translation>Aufgezeichnete Gesichter, Live Link Face (*.csv)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Recorded {seconds:.1f} s into {path}</source>
            <translation>{seconds:.1f} s aufgenommen in {path}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/figures_table.py" />
            <source>recording</source>
            <translation>Aufnahme</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Recordings Folder…</source>
            <translation>Ordner für Aufnahmen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/microphone_bar.py" />
            <source>Recordings Go to {folder}…</source>
            <translation>Aufnahmen kommen nach {folder}…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Recording…</source>
            <translation>Aufzeichnung…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Rectangle</source>
            <translation>Rechteck</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>red dots, by Burg's method, as Praat measures them</source>
            <translation>rote Punkte, nach Burg, wie Praat sie misst</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>refuse</source>
            <translation>ablehnen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>relabel {take}</source>
            <translation>Umbenennen von {take}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>release</source>
            <translation>Release</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>removal of {name}</source>
            <translation>Entfernen von {name}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Remove</source>
            <translation>Entfernen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Remove a variable</source>
            <translation>Variable entfernen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Remove Variable…</source>
            <translation>Variable entfernen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>Remove {name}</source>
            <translation>{name} entfernen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/dialogs.py" />
            <source>Remove {what} from the disk for ever? What was done to takes before cannot be undone then.</source>
            <translation>Endgültig {what} vom Datenträger entfernen? Was vorher an den Takes geändert wurde, lässt sich dann nicht mehr rückgängig machen.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Removes what lies below start (hum, rumble), and fades in up to end.</source>
            <translation>Entfernt, was unter dem Anfang liegt (Brummen, Rumpeln), und blendet bis zum Ende ein.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Rename Label…</source>
            <translation>Beschriftung umbenennen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Rename the label</source>
            <translation>Beschriftung umbenennen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Replace</source>
            <translation>Ersetzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/ship_dialog.py" />
            <source>replace files that were changed there, too</source>
            <translation>auch Dateien ersetzen, die dort geändert wurden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Replace files?</source>
            <translation>Dateien ersetzen?</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/threshold_view.py" />
            <source>reset</source>
            <translation>zurücksetzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Reset Layout</source>
            <translation>Anordnung zurücksetzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>reset of {what}</source>
            <translation>Zurücksetzen ({what})</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/threshold_view.py" />
            <source>Reset to what the preset's file says</source>
            <translation>Auf den Wert aus der Datei des Presets zurücksetzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/plot_menu.py" />
            <source>Reset Zoom</source>
            <translation>Zoom zurücksetzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>reset {text}</source>
            <translation>{text} zurücksetzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>Reset {text} to what the preset's file says</source>
            <translation>{text} auf den Wert aus der Datei des Presets zurücksetzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>restore {take}</source>
            <translation>Wiederherstellen von {take}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Return</source>
            <translation>Return</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>return to the file</source>
            <translation>Rückkehr zur Datei</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Right</source>
            <translation>Rechts</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>right</source>
            <translation>rechts</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>right-half</source>
            <translation>rechte Hälfte</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Romanian</source>
            <translation>Rumänisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/room_model.py" />
            <source>room</source>
            <translation>Raum</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>room noise {decibels:.0f} dB</source>
            <translation>Raumgeräusch {decibels:.0f} dB</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/room_model.py" />
            <source>Room of {room}: {sure}; Ctrl+Z takes it back.</source>
            <translation>Raum mit {room}: {sure}; Strg+Z nimmt es zurück.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Rules of your own over frequency bands: every comparison shows its margin, and every limit can be dragged.</source>
            <translation>Eigene Regeln über Frequenzbändern: Jeder Vergleich zeigt seinen Abstand, jede Grenze lässt sich ziehen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Russian</source>
            <translation>Russisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Russian (Classic)</source>
            <translation>Russisch (klassisch)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Russian (Latvia)</source>
            <translation>Russisch (Lettland)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/confusion_view.py" />
            <source>said</source>
            <translation>gesagt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/confusion_view.py" />
            <source>said and recognised</source>
            <translation>gesagt und erkannt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/confusion_view.py" />
            <source>said ↓</source>
            <translation>gesagt ↓</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>said, not</source>
            <translation>gesagt, nicht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/microphone_bar.py" />
            <source>sample rate</source>
            <translation>Abtastrate</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/microphone_bar.py" />
            <source>Sample rate of the microphone; the best is 44 100 Hz where it can do that</source>
            <translation>Abtastrate des Mikrofons; am besten sind 44 100 Hz, wenn es das kann</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Save as TOML…</source>
            <translation>Als TOML speichern…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Save As…</source>
            <translation>Speichern unter…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>Save Curve…</source>
            <translation>Kurve speichern…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Save Labels</source>
            <translation>Beschriftungen speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Save Labels As…</source>
            <translation>Beschriftungen speichern unter…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Save Picture…</source>
            <translation>Bild speichern…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Save Preset</source>
            <translation>Preset speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Save Preset As…</source>
            <translation>Preset speichern unter…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Save Selection as Sound…</source>
            <translation>Auswahl als Klang speichern…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Save the 21 Numbers Only</source>
            <translation>Nur die 21 Zahlen speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Save the averaged spectrum</source>
            <translation>Gemitteltes Spektrum speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>Save the averaged spectrum, or load saved ones to compare with</source>
            <translation>Das gemittelte Spektrum speichern oder gespeicherte zum Vergleich laden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Save the changes to the preset {preset}?</source>
            <translation>Die Änderungen am Preset {preset} speichern?</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Save the labels</source>
            <translation>Beschriftungen speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Save the labels of {sound}, which you changed?</source>
            <translation>Die geänderten Beschriftungen von {sound} speichern?</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Save the phonemes</source>
            <translation>Phoneme speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Save the Phonemes…</source>
            <translation>Phoneme speichern…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Save the picture</source>
            <translation>Bild speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Save the preset</source>
            <translation>Preset speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/selection_dialogs.py" />
            <source>Save the selected sound</source>
            <translation>Ausgewählten Klang speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Save the spoken text</source>
            <translation>Gesprochenen Text speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Save the words</source>
            <translation>Wörter speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Save the words of {sound}, whose boundaries you moved?</source>
            <translation>Die Wörter von {sound} speichern, deren Grenzen verschoben wurden?</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Save what was heard as a sound (Selection &gt; Save Selection as Sound…), open that, and label it.</source>
            <translation>Das Gehörte als Klang speichern (Auswahl &gt; Auswahl als Klang speichern…), diesen öffnen und beschriften.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Save words and phones, or the text as a voice says it</source>
            <translation>Wörter und Phone speichern, oder den Text so, wie eine Stimme ihn spricht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Save ▾</source>
            <translation>Speichern ▾</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/label_tiers.py" />
            <source>Saved the labels as {path}</source>
            <translation>Die Beschriftungen sind als {path} gespeichert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/label_tiers.py" />
            <source>Saved the labels as {path}, without {columns}, which Audacity's labels do not hold.</source>
            <translation>Labels als {path} gespeichert, ohne {columns}; das fasst das Format von Audacity nicht.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Saved the spoken text as {path}, with words and phones beside it</source>
            <translation>Der gesprochene Text ist als {path} gespeichert, mit Wörtern und Phonen daneben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>Saved words and phones as {path}.</source>
            <translation>Wörter und Phone sind als {path} gespeichert.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/selection.py" />
            <source>Saved {seconds:.2f} s of {path} as {target}</source>
            <translation>{seconds:.2f} s aus {path} als {target} gespeichert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>saving the spoken text …</source>
            <translation>gesprochener Text wird gespeichert …</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Say</source>
            <translation>Sprechen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Say nine single sounds in place of the sentence that is learned from</source>
            <translation>Neun einzelne Laute sprechen statt des Satzes, von dem gelernt wird</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Say the sound before once more</source>
            <translation>Vorigen Laut noch einmal</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Say the text</source>
            <translation>Den Text sprechen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/driver_model.py" />
            <source>Say the text once more: a recorded face is looked up while it is spoken.</source>
            <translation>Den Text noch einmal sprechen lassen: Ein aufgezeichnetes Gesicht wird während des Sprechens nachgeschlagen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Say this once more (R)</source>
            <translation>Dies noch einmal sprechen (R)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Say this sound once more</source>
            <translation>Diesen Laut noch einmal</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Say what came before once more (Backspace)</source>
            <translation>Das Vorige noch einmal sprechen (Rücktaste)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/waveform_view.py" />
            <source>scale</source>
            <translation>Maßstab</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>script</source>
            <translation>Skript</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Scripts (*.txt *.docx *.TextGrid *.json);;All files (*)</source>
            <translation>Skripte (*.txt *.docx *.TextGrid *.json);;Alle Dateien (*)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Script…</source>
            <translation>Skript…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/manual.py" />
            <source>search</source>
            <translation>suchen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/variables_panel.py" />
            <source>Search for frequency ranges that part these two best</source>
            <translation>Frequenzbereiche suchen, die diese beiden am besten trennen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Search for thresholds that suit what is loaded, with those in use to begin with</source>
            <translation>Schwellen suchen, die zum Geladenen passen, ausgehend von den benutzten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/manual.py" />
            <source>search the manual</source>
            <translation>im Handbuch suchen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Searching; you can go on working meanwhile.</source>
            <translation>Die Suche läuft; währenddessen kann weitergearbeitet werden.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>second</source>
            <translation>zweites</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/tone_bar.py" />
            <source>Second formant</source>
            <translation>Zweiter Formant</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Second Preset…</source>
            <translation>Zweites Preset…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>See the whole file</source>
            <translation>Die ganze Datei zeigen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>See the whole sound</source>
            <translation>Den ganzen Klang sehen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>See what is selected (Shift+drag selects)</source>
            <translation>Die Auswahl zeigen (Umschalt+Ziehen wählt aus)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Seed</source>
            <translation>Zufallszahl</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Select All</source>
            <translation>Alles auswählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>selection</source>
            <translation>Auswahl</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Send phonemes, mouth shapes and the weights of the movestates over the network, as OSC messages of the VMC protocol, which VTuber programs understand</source>
            <translation>Phoneme, Mundformen und die Gewichte der Movestates über das Netzwerk senden, als OSC-Nachrichten des VMC-Protokolls, das VTuber-Programme verstehen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Send the mouth (OSC) to</source>
            <translation>Mund senden (OSC) an</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/osc_model.py" />
            <source>sending, {n} packets</source>
            <translation>sendet, {n} Pakete</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>sentence</source>
            <translation>Satz</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/variables_panel.py" />
            <source>separates</source>
            <translation>trennt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Serbian</source>
            <translation>Serbisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Set all sliders back to 0</source>
            <translation>Alle Regler auf 0 zurücksetzen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Sets amplitudes below the threshold to 0.</source>
            <translation>Setzt Amplituden unter der Schwelle auf 0.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>Several people speak in these labels; choose the speaker below the text.</source>
            <translation>In diesen Labels sprechen mehrere Personen; Sprecher unter dem Text wählen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Shan (Tai Yai)</source>
            <translation>Shan</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>Shapes and times vary a little, as they do in people</source>
            <translation>Formen und Zeiten schwanken ein wenig, wie bei Menschen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/figures_table.py" />
            <source>Share of frames of a, e, i, o and u that are right</source>
            <translation>Anteil der richtigen Frames von a, e, i, o und u</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/figures_table.py" />
            <source>Share of frames that are right</source>
            <translation>Anteil der richtigen Frames</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/figures_table.py" />
            <source>Share of frames with the right one of six mouth shapes</source>
            <translation>Anteil der Frames mit der richtigen von sechs Mundformen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/figures_table.py" />
            <source>Share of silent frames that are called silence</source>
            <translation>Anteil der stillen Frames, die Stille heißen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/figures_table.py" />
            <source>Share of spoken frames that are called silence</source>
            <translation>Anteil der gesprochenen Frames, die Stille heißen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/viseme_panel.py" />
            <source>share of the mouth shape {shape}</source>
            <translation>Anteil der Mundform {shape}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/ship_dialog.py" />
            <source>Ship</source>
            <translation>Ausliefern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/ship_dialog.py" />
            <source>Ship a Preset</source>
            <translation>Ein Preset ausliefern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Ship Preset…</source>
            <translation>Preset ausliefern…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Shipped {n} files into {folder}; README.md there says how to go on</source>
            <translation>{n} Dateien nach {folder} ausgeliefert; README.md dort sagt, wie es weitergeht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Shipping for {target} into {folder} …</source>
            <translation>Wird für {target} nach {folder} ausgeliefert …</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/microphone_bar.py" />
            <source>Short Buffer: Blocks of 10 ms, the Least Latency</source>
            <translation>Kurzer Puffer: Blöcke von 10 ms, geringste Latenz</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Shortest cue</source>
            <translation>Kürzester Abschnitt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Show a face that Live Link Face recorded (CSV) beside the speech, in step with the sound in hand</source>
            <translation>Ein Gesicht zeigen, das Live Link Face aufgezeichnet hat (CSV), neben der Sprache und im Takt mit dem Klang</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>Show a mesh of your own (.obj, .glb, .gltf, .x), with its movestates (.3dm)</source>
            <translation>Ein eigenes Netz zeigen (.obj, .glb, .gltf, .x), mit seinen Movestates (.3dm)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Show a second head in step, which other means move</source>
            <translation>Einen zweiten Kopf im Takt zeigen, der anders bewegt wird</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Show in the matrix how much more often the preset in use gives each answer</source>
            <translation>In der Matrix zeigen, wie viel häufiger das benutzte Preset jede Antwort gibt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>Show the head that ships with the program</source>
            <translation>Den mitgelieferten Kopf zeigen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Show what other programs send: /expression NAME 0..1, or the blend shapes of a face tracker (VMC)</source>
            <translation>Zeigen, was andere Programme senden: /expression NAME 0..1 oder die Blendshapes einer Gesichtserfassung (VMC)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Shown under the sonagram:</source>
            <translation>Unter dem Sonagramm gezeigt:</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Shows the spectrum through triangular filters, spaced as the ear hears (HTK mel); variables can measure it.</source>
            <translation>Zeigt das Spektrum durch Dreiecksfilter, die wie das Gehör verteilt sind (HTK-Mel); Variablen können es messen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Silence</source>
            <translation>Stille</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/figures_table.py" />
            <source>silence found</source>
            <translation>Stille gefunden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Silent</source>
            <translation>Stumm</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>silent</source>
            <translation>stumm</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>since {event}</source>
            <translation>seit {event}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>sine</source>
            <translation>Sinus</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>single sounds</source>
            <translation>einzelne Laute</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Sinhala</source>
            <translation>Singhalesisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>skip ▶</source>
            <translation>überspringen ▶</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Sliders and time line</source>
            <translation>Regler und Zeitleiste</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Slovak</source>
            <translation>Slowakisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Slovenian</source>
            <translation>Slowenisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Slower</source>
            <translation>Langsamer</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>smile</source>
            <translation>Lächeln</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>So small a gain on so little speech may be chance. Listen to both, then choose.</source>
            <translation>Ein so kleiner Gewinn bei so wenig Sprache kann Zufall sein. Beides anhören, dann wählen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/level_meter.py" />
            <source>soft</source>
            <translation>leise</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Something was heard in the silence ({db} dB, where the room has {room} dB); keep quiet and record it again.</source>
            <translation>In der Stille war etwas zu hören ({db} dB, wo der Raum {room} dB hat); still sein und noch einmal aufnehmen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/app.py" />
            <source>Something went wrong in the program itself; the details are in {log}.</source>
            <translation>Im Programm selbst ist etwas schiefgegangen; Näheres steht in {log}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>sorrow</source>
            <translation>Trauer</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Sound</source>
            <translation>Klang</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/take_list.py" />
            <source>sound</source>
            <translation>Laut</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>sound cannot be played or recorded, since PortAudio is missing or broken; install libportaudio2</source>
            <translation>Klang kann weder abgespielt noch aufgenommen werden, da PortAudio fehlt oder defekt ist; libportaudio2 installieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>sound cannot be played or recorded, since the package sounddevice is missing; pip install sounddevice</source>
            <translation>Klang kann weder abgespielt noch aufgenommen werden, da das Paket sounddevice fehlt; pip install sounddevice</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>sound of the take</source>
            <translation>Laut des Takes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/dialogs.py" />
            <source>sound of {name}</source>
            <translation>Laut von {name}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/variables_panel.py" />
            <source>Sound that is to be told apart</source>
            <translation>Laut, der unterschieden werden soll</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>Sound that never came from the microphone, since listening began</source>
            <translation>Klang, der seit Beginn des Zuhörens nie vom Mikrofon ankam</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Sound {index} of {n}</source>
            <translation>Laut {index} von {n}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Sounds</source>
            <translation>Laute</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>sounds that are exported</source>
            <translation>Klänge, die exportiert werden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Sounds to export</source>
            <translation>Klänge zum Exportieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Sounds with Labels Beside Them…</source>
            <translation>Klänge mit Beschriftungen daneben…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>sounds, by the mouth table</source>
            <translation>Laute, nach der Mundtabelle</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>source</source>
            <translation>Quelle</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Spanish</source>
            <translation>Spanisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Spanish (Latin America)</source>
            <translation>Spanisch (Lateinamerika)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Spanish (Spain)</source>
            <translation>Spanisch (Spanien)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/welcome.py" />
            <source>Speak, and the letters follow; nothing is recorded until you press R.</source>
            <translation>Sprechen, und die Buchstaben folgen; aufgenommen wird erst mit der Taste R.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Speaker</source>
            <translation>Sprecher</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/take_list.py" />
            <source>speaker</source>
            <translation>Sprecher</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Spectra in dB</source>
            <translation>Spektren in dB</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/page.py" />
            <source>Spectrum</source>
            <translation>Spektrum</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_dialog.py" />
            <source>spectrum</source>
            <translation>Spektrum</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/figures_table.py" />
            <source>speech called silence</source>
            <translation>Sprache als Stille</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/recogniser_choice.py" />
            <source>Speech Encoder</source>
            <translation>Sprach-Encoder</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Speech Encoder…</source>
            <translation>Sprach-Encoder…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>speech priority</source>
            <translation>Vorrang der Sprache</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Speed {percent:.0f} %</source>
            <translation>Tempo {percent:.0f} %</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Spoken Text as Sound…</source>
            <translation>Gesprochenen Text als Klang…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Start</source>
            <translation>Beginnen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>start</source>
            <translation>los</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>State</source>
            <translation>Stand</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Statistics</source>
            <translation>Statistik</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/phoneme_view.py" />
            <source>statistics: {recognised} → {phoneme}</source>
            <translation>Statistik: {recognised} → {phoneme}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Stop</source>
            <translation>Stopp</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Stop (Escape)</source>
            <translation>Stopp (Esc)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Stop (Escape); a file goes to its beginning</source>
            <translation>Stopp (Esc); eine Datei geht an ihren Anfang</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Stop saying it</source>
            <translation>Das Sprechen beenden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/variables_panel.py" />
            <source>stop {percent:.0f} %</source>
            <translation>Stopp {percent:.0f} %</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>Stretches</source>
            <translation>Strecken</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>stretches of the cell</source>
            <translation>Strecken der Zelle</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/variables_panel.py" />
            <source>suggest</source>
            <translation>vorschlagen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>sum</source>
            <translation>Summe</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>surprise</source>
            <translation>Überraschung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Swahili</source>
            <translation>Suaheli</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Swedish</source>
            <translation>Schwedisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>sweep</source>
            <translation>Gleitton</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>syllable</source>
            <translation>Silbe</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/words_view.py" />
            <source>syllables</source>
            <translation>Silben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>syllables/s</source>
            <translation>Silben/s</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>system</source>
            <translation>System</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>SZ and SCH</source>
            <translation>SZ und SCH</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>SZ if both, SCH if the first only</source>
            <translation>SZ bei beiden, SCH bei nur dem ersten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>Table</source>
            <translation>Tabelle</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>table of recorded faces</source>
            <translation>Tabelle aufgezeichneter Gesichter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Tables of recorded faces (*.sqlite)</source>
            <translation>Tabellen aufgezeichneter Gesichter (*.sqlite)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>take</source>
            <translation>Take</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Take speakers’ names, [directions], *emphasis*, &lt;tags&gt; and &amp;entities; of a script as words; otherwise they are not spoken</source>
            <translation>Sprechernamen, [Regieanweisungen], *Betonung*, &lt;tags&gt; und &amp;Entitäten; eines Skripts als Wörter nehmen; sonst werden sie nicht gesprochen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/take_list.py" />
            <source>takes</source>
            <translation>Takes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Takes go into a folder that you may choose</source>
            <translation>Takes kommen in einen Ordner nach Wahl</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Talk</source>
            <translation>Sprechen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Tatar</source>
            <translation>Tatarisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/sources.py" />
            <source>text</source>
            <translation>Text</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Thai</source>
            <translation>Thailändisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>The calibrated preset is in use, and not saved yet.</source>
            <translation>Das kalibrierte Preset ist in Gebrauch, aber noch nicht gespeichert.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>the card does not tell which part of it is the microphone's</source>
            <translation>die Karte verrät nicht, welcher Teil davon auf das Mikrofon fällt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/variables_panel.py" />
            <source>The chance that of two frames of different sounds a threshold tells which is which: 50 % says nothing</source>
            <translation>Wie wahrscheinlich eine Schwelle von zwei Frames verschiedener Laute sagt, welcher welcher ist: 50 % sagt nichts</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>The changes of the preset {name} that were not saved when the program ended are here again.</source>
            <translation>Die Änderungen am Preset {name}, die beim Programmende nicht gespeichert waren, sind wieder da.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>The changes that were not saved when the program ended cannot be read: {error}</source>
            <translation>Die Änderungen, die beim Programmende nicht gespeichert waren, lassen sich nicht lesen: {error}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/microphone_bar.py" />
            <source>The channel that is heard and recorded, or the first two: mixed and recorded as stereo</source>
            <translation>Der Kanal, der gehört und aufgenommen wird, oder die ersten beiden: gemischt gehört, in Stereo aufgenommen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>The command that speaks, such as: {example}</source>
            <translation>Der Befehl, der spricht, zum Beispiel: {example}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/dialogs.py" />
            <source>the deleted take</source>
            <translation>den gelöschten Take</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>the eyes blink</source>
            <translation>die Augen blinzeln</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>The eyes blink at human intervals</source>
            <translation>Die Augen blinzeln in menschlichen Abständen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_view.py" />
            <source>the file over time</source>
            <translation>die Datei über der Zeit</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/ship_dialog.py" />
            <source>The folder has the preset, an ear that hears with it, and a README that says how to go on.</source>
            <translation>Der Ordner enthält das Preset, ein Ohr, das damit hört, und eine README, die sagt, wie es weitergeht.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/dialogs.py" />
            <source>The folder of the takes</source>
            <translation>Der Ordner der Takes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/recogniser_choice.py" />
            <source>The folder with model.bin of Whisper base</source>
            <translation>Der Ordner mit model.bin von Whisper base</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/head_view.py" />
            <source>the head</source>
            <translation>der Kopf</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/head_view.py" />
            <source>The head cannot be shown: {sentence}.</source>
            <translation>Der Kopf kann nicht gezeigt werden: {sentence}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>the head moves</source>
            <translation>der Kopf bewegt sich</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>The head moves with pitch and loudness of the voice</source>
            <translation>Der Kopf bewegt sich mit Tonhöhe und Lautstärke der Stimme</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>the head or a face of yours</source>
            <translation>der Kopf oder ein eigenes Gesicht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>The head, when it has the focus</source>
            <translation>Der Kopf, wenn er im Fokus ist</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>The language of a text is not guessed; choose it below the text.</source>
            <translation>Die Sprache eines Textes wird nicht geraten; sie unter dem Text wählen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>The language of the sentences that are read</source>
            <translation>Die Sprache der Sätze, die gelesen werden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>The language of the text, which is not guessed</source>
            <translation>Die Sprache des Textes, die nicht geraten wird</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>the language’s own</source>
            <translation>die der Sprache</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>The latency was not measured: {why}.</source>
            <translation>Die Latenz wurde nicht gemessen: {why}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>the likeliest is named</source>
            <translation>der wahrscheinlichste gilt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>The marked stretch of the file begins where the file stands ([)</source>
            <translation>Die markierte Strecke beginnt, wo die Datei steht ([)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>The marked stretch of the file ends where the file stands (])</source>
            <translation>Die markierte Strecke endet, wo die Datei steht (])</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/figures_table.py" />
            <source>The mean F1 of the ten sounds: no figure hides a rare one</source>
            <translation>Das mittlere F1 der zehn Laute: Kein seltener geht in der Zahl unter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>The mean of all spectra that were heard since Play, Record or Clear; when other filters are heard, a new mean begins</source>
            <translation>Das Mittel aller Spektren, die seit Abspielen, Aufnehmen oder Leeren gehört wurden; mit anderen Filtern beginnt ein neues Mittel</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>The microphone changed its form on the way, so what came before that is in {files}.</source>
            <translation>Das Mikrofon hat unterwegs seine Form geändert; was davor kam, ist in {files}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/session.py" />
            <source>The microphone heard nothing yet; listen to it, then look back.</source>
            <translation>Das Mikrofon hat noch nichts gehört; erst zuhören, dann zurückschauen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>The microphone is there: {status}; {lost}.</source>
            <translation>Das Mikrofon ist da: {status}; {lost}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>the microphone {name} is not there; choose one of: {names}</source>
            <translation>das Mikrofon {name} ist nicht da; eines davon wählen: {names}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/microphone_bar.py" />
            <source>The microphone, by name and sound system: {name}</source>
            <translation>Das Mikrofon, nach Name und Tonsystem: {name}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>The movestates of the avatar that receives them: those of the head’s table, or another set</source>
            <translation>Die Movestates des Avatars, der sie empfängt: die der Tabelle des Kopfes oder ein anderer Satz</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>The nearest of nine mean spectra wins, as in uLipSync; best made from takes of one voice.</source>
            <translation>Das nächste von neun mittleren Spektren gewinnt, wie bei uLipSync; am besten aus Takes einer Stimme.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>The new preset is not saved yet.</source>
            <translation>Das neue Preset ist noch nicht gespeichert.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/waveform_view.py" />
            <source>The newest window of 46.4 ms, after the filters of the time domain; full scale is ±1</source>
            <translation>Das neueste Fenster von 46.4 ms, nach den Filtern des Zeitbereichs; Vollaussteuerung ist ±1</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/manual.py" />
            <source>the page</source>
            <translation>die Seite</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>The page Calibrate</source>
            <translation>Die Seite Kalibrieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/pages.py" />
            <source>The page {name} (Ctrl+{number})</source>
            <translation>Die Seite {name} (Strg+{number})</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/phoneme_view.py" />
            <source>The phoneme now, its intensity, how sure it is (of a hundred answers that are 80 % sure, eighty are right), how often the phoneme changed in the last three seconds, the measures of its window of 46 ms: zc (zero crossings in it), vol (peak level, full scale 1), e (energy: sum of the amplitudes before denoise and normalise), f(g) (fundamental frequency of a voice, 60 to 500 Hz; a higher tone has none), and what each rule said, down to the one that fired</source>
            <translation>Das Phonem jetzt, seine Intensität, wie sicher es ist (von hundert Antworten mit 80 % Sicherheit sind achtzig richtig), wie oft das Phonem in den letzten drei Sekunden wechselte, die Maße seines Fensters von 46 ms: zc (Nulldurchgänge darin), vol (Spitzenpegel, Vollaussteuerung 1), e (Energie: Summe der Amplituden vor Entrauschen und Normieren), f(g) (Grundfrequenz einer Stimme, 60 bis 500 Hz; ein höherer Ton hat keine), und was jede Regel sagte, bis zu der, die zutraf</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>the phoneme that is heard</source>
            <translation>das gehörte Phonem</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>The phoneme that is heard now, and its intensity</source>
            <translation>Das Phonem, das jetzt zu hören ist, und seine Intensität</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/phoneme_writer.py" />
            <source>The phonemes of {name} are looked for, and then saved in {target} …</source>
            <translation>Die Phoneme von {name} werden gesucht und dann in {target} gespeichert …</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/phoneme_writer.py" />
            <source>The phonemes of {name} are saved in {target}, heard with: {ear}.</source>
            <translation>Die Phoneme von {name} sind in {target} gespeichert, gehört mit: {ear}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>The program ended while it recorded; {seconds:.1f} s of {begun:%Y-%m-%d, %H:%M} are safe in {path}{others}</source>
            <translation>Das Programm endete während einer Aufnahme; {seconds:.1f} s vom {begun:%Y-%m-%d, %H:%M} sind sicher in {path}{others}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>the program's own head</source>
            <translation>der mitgelieferte Kopf</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/variables_panel.py" />
            <source>The recogniser {name} cannot use variables of your own; {why}</source>
            <translation>Der Erkenner {name} kann eigene Variablen nicht benutzen; {why}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_model.py" />
            <source>The recogniser {recogniser} has no thresholds; the guided calibration teaches it your voice.</source>
            <translation>Der Erkenner {recogniser} hat keine Schwellen; die geführte Kalibrierung bringt ihm die Stimme bei.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>The recording doesn’t seem to match this text.</source>
            <translation>Die Aufnahme scheint nicht zu diesem Text zu passen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>the recording waits for it</source>
            <translation>die Aufnahme wartet darauf</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>the room is not measured yet</source>
            <translation>der Raum ist noch nicht gemessen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/room_model.py" />
            <source>The room was not heard to the end, since the microphone was let go; measure it again.</source>
            <translation>Der Raum wurde nicht zu Ende gehört, weil das Mikrofon freigegeben wurde; noch einmal messen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>The rules of the thesis as it describes them: weak, but every step shows.</source>
            <translation>Die Regeln der Thesis, wie sie sie beschreibt: schwach, aber jeder Schritt ist zu sehen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>The rules of the thesis with hysteresis, on sound that quantising does not fold.</source>
            <translation>Die Regeln der Thesis mit Hysterese, auf Klang, den das Quantisieren nicht faltet.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>The rules of the thesis with hysteresis: fewer changes.</source>
            <translation>Die Regeln der Thesis mit Hysterese: weniger Wechsel.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>The rules of the thesis with the 21 numbers of a PhonemeData file.</source>
            <translation>Die Regeln der Thesis mit den 21 Zahlen einer PhonemeData-Datei.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>the same without the page, as an npm package</source>
            <translation>dasselbe ohne die Seite, als npm-Paket</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_model.py" />
            <source>the sender has stopped</source>
            <translation>Sender hat aufgehört</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>The silence lasted {seconds} s and should last {least} s or more; keep quiet for longer.</source>
            <translation>Die Stille dauerte {seconds} s und sollte mindestens {least} s dauern; länger still sein.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>The sonagram after all filters that are on, as recognisers see it</source>
            <translation>Das Sonagramm nach allen eingeschalteten Filtern, so wie Erkenner es sehen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>the sound card cannot be opened ({reason})</source>
            <translation>die Soundkarte kann nicht geöffnet werden ({reason})</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/original_model.py" />
            <source>The sound of {recording} is not beside its table any more, so only its face is shown; put the recordings where they were: {folder}.</source>
            <translation>Der Klang von {recording} liegt nicht mehr neben seiner Tabelle, daher ist nur das Gesicht zu sehen; die Aufzeichnungen dorthin legen, wo sie waren: {folder}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>the sound system does not answer ({reason}); check that it runs</source>
            <translation>das Tonsystem antwortet nicht ({reason}); prüfen, ob es läuft</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/page.py" />
            <source>The spectrum of the newest window of 46.4 ms, after all filters that are on</source>
            <translation>Das Spektrum des neuesten Fensters von 46.4 ms, nach allen eingeschalteten Filtern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_model.py" />
            <source>The stretch of {path} lasts {seconds:.2f} s; mark a longer one.</source>
            <translation>Die Strecke aus {path} dauert {seconds:.2f} s; eine längere markieren.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>the system's output</source>
            <translation>Ausgabe des Systems</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>The text below the head</source>
            <translation>Der Text unter dem Kopf</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>The text is right: find its words, though another text seems to be said</source>
            <translation>Der Text stimmt: seine Wörter suchen, auch wenn ein anderer gesprochen scheint</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>the text on Talk</source>
            <translation>der Text unter Sprechen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/unsaved.py" />
            <source>The unsaved changes cannot be kept for the next start: {error}</source>
            <translation>Die ungespeicherten Änderungen können nicht für den nächsten Start behalten werden: {error}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/scroll_view.py" />
            <source>The variable whose course and extremes are shown</source>
            <translation>Die Variable, deren Verlauf und Grenzen gezeigt werden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>The variable whose course is shown</source>
            <translation>Die Variable, deren Verlauf gezeigt wird</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/waveform_view.py" />
            <source>The vertical scale follows the loudness; the slider beside it ends that</source>
            <translation>Der senkrechte Maßstab folgt der Lautstärke; der Regler daneben beendet das</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>The views stand still while sound goes on; click, or press F, and they go on</source>
            <translation>Die Ansichten stehen still, während der Klang weitergeht; ein Klick oder F lässt sie weiterlaufen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/position_slider.py" />
            <source>The whole file: how loud it is, in the colours of its phonemes (grey where it is not analysed yet). Click to go there; arrow keys go by a second</source>
            <translation>Die ganze Datei: wie laut sie ist, in den Farben ihrer Phoneme (grau, wo noch nicht analysiert). Klicken, um dorthin zu gehen; Pfeiltasten gehen um eine Sekunde</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>The whole of it</source>
            <translation>Das Ganze</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>The words of the sound</source>
            <translation>Text der Aufnahme</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Theme</source>
            <translation>Farben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>There are no labels yet; load some by Labels &gt; Load Labels.</source>
            <translation>Es gibt noch keine Beschriftungen; welche laden mit Beschriftungen &gt; Beschriftungen laden.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>There are no labels yet; select a stretch and insert one by Ctrl+I.</source>
            <translation>Es gibt noch keine Beschriftungen; eine Strecke auswählen und mit Strg+I eine einfügen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_model.py" />
            <source>There are no takes yet whose labels could be written; record one first.</source>
            <translation>Es gibt noch keine Takes, deren Beschriftungen geschrieben werden könnten; zuerst einen aufnehmen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>There are no variables of your own yet; mark a range on the averaged spectrum first.</source>
            <translation>Es gibt noch keine eigenen Variablen; zuerst einen Bereich im gemittelten Spektrum markieren.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/export_queue.py" />
            <source>there are no words beside it</source>
            <translation>daneben liegen keine Wörter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>There are no words to save; open a sound and align its text.</source>
            <translation>Es gibt keine Wörter zu speichern; einen Klang öffnen und seinen Text ausrichten.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>There is no averaged spectrum yet; play a sound first.</source>
            <translation>Es gibt noch kein gemitteltes Spektrum; zuerst einen Klang abspielen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>There is no error after this place.</source>
            <translation>Nach dieser Stelle gibt es keinen Fehler.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>There is no error before this place.</source>
            <translation>Vor dieser Stelle gibt es keinen Fehler.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/model.py" />
            <source>There is no file in hand; open one to mark a stretch of it.</source>
            <translation>Es ist keine Datei geöffnet; eine öffnen, um eine Strecke darin zu markieren.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>there is no microphone; plug one in, or check that the sound system runs</source>
            <translation>es gibt kein Mikrofon; eines anschließen oder prüfen, ob das Tonsystem läuft</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/recogniser_choice.py" />
            <source>there is no model yet: fetch it, or choose the folder of one that you have</source>
            <translation>Es gibt noch kein Modell: eines holen oder den Ordner eines vorhandenen wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/whole_file.py" />
            <source>There is no second preset yet; choose one by Analysis &gt; Second Preset.</source>
            <translation>Es gibt noch kein zweites Preset; eines wählen mit Analyse &gt; Zweites Preset.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>There is no sound file in hand; open the one that the labels belong to.</source>
            <translation>Es ist keine Klangdatei geöffnet; die öffnen, zu der die Beschriftungen gehören.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>There is no sound file in hand; open the one whose phonemes are to be saved.</source>
            <translation>Es ist keine Klangdatei geöffnet; die öffnen, deren Phoneme gespeichert werden sollen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>There is no sound file in hand; open the recording of this script, then the script.</source>
            <translation>Keine Audiodatei geöffnet; zuerst die Aufnahme zu diesem Skript öffnen, dann das Skript.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>There is no sound file in hand; open the recording of this text, then align.</source>
            <translation>Es ist keine Klangdatei geöffnet; erst die Aufnahme dieses Textes öffnen, dann ausrichten.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>There is no text; write what is said into the field below the head.</source>
            <translation>Es gibt keinen Text; in das Feld unter dem Kopf schreiben, was gesagt wird.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_model.py" />
            <source>There is nothing to search in yet; record takes or load labelled recordings first.</source>
            <translation>Es gibt noch nichts zu durchsuchen; Takes aufnehmen oder beschriftete Aufnahmen laden.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/dialogs.py" />
            <source>These names stand for no sound that is known here. Say what each one is; what stays unidentified counts neither as right nor as wrong.</source>
            <translation>Diese Namen stehen für keinen hier bekannten Laut. Bitte sagen, was jeder ist; was unbekannt bleibt, zählt weder als richtig noch als falsch.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/tone_bar.py" />
            <source>Third formant</source>
            <translation>Dritter Formant</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>this takes a few seconds</source>
            <translation>das dauert einige Sekunden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>those of the nearest duration</source>
            <translation>die mit der nächsten Dauer</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>those that fit and join best (Viterbi)</source>
            <translation>die am besten passen und verbinden (Viterbi)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Thresholds</source>
            <translation>Schwellen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/threshold_view.py" />
            <source>thresholds</source>
            <translation>Schwellen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_dialog.py" />
            <source>through the mel bank</source>
            <translation>durch die Mel-Filterbank</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>tier that is compared with what is recognised</source>
            <translation>Ebene, mit der das Erkannte verglichen wird</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Tiers</source>
            <translation>Ebenen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>tiers that are shown</source>
            <translation>gezeigte Ebenen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Tiers…</source>
            <translation>Ebenen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/take_waveform.py" />
            <source>time (s)</source>
            <translation>Zeit (s)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/scroll_view.py" />
            <source>time before now (s)</source>
            <translation>Zeit vor jetzt (s)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/waveform_view.py" />
            <source>time in the window</source>
            <translation>Zeit im Fenster</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/position_slider.py" />
            <source>time line</source>
            <translation>Zeitleiste</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Time smoothing</source>
            <translation>Zeitglättung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>Times</source>
            <translation>Zeiten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Timing</source>
            <translation>Zeiten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_dialog.py" />
            <source>to</source>
            <translation>bis</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/tone_bar.py" />
            <source>to </source>
            <translation>bis </translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>To the Beginning</source>
            <translation>Zum Anfang</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>To the End</source>
            <translation>Zum Ende</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/sources.py" />
            <source>tone</source>
            <translation>Ton</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>too late</source>
            <translation>zu spät</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>too noisy</source>
            <translation>zu verrauscht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>too quiet</source>
            <translation>zu leise</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>too short</source>
            <translation>zu kurz</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Totontepec Mixe</source>
            <translation>Totontepec-Mixe</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Transport</source>
            <translation>Wiedergabe</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/take_waveform.py" />
            <source>trim the take</source>
            <translation>den Take zuschneiden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>trim {take}</source>
            <translation>Zuschneiden von {take}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Turkish</source>
            <translation>Türkisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Turkmen</source>
            <translation>Turkmenisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>Turn the page where what is heard leaves it</source>
            <translation>Weiterblättern, wenn das Gehörte den Ausschnitt verlässt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/recogniser_choice.py" />
            <source>twin</source>
            <translation>Zwilling</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>twin, {seconds} s each way</source>
            <translation>Zwilling, {seconds} s in beide Richtungen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>two seconds of your room, with nobody speaking</source>
            <translation>zwei Sekunden Raum, ohne dass jemand spricht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/threshold_view.py" />
            <source>type a number, or arrow keys</source>
            <translation>eine Zahl eingeben, oder Pfeiltasten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Ukrainian</source>
            <translation>Ukrainisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Undo Them</source>
            <translation>Rückgängig machen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>unheard speakers: macro F1 {macro_f1:.2f}, right mouth shapes {percent:.0f} %</source>
            <translation>ungehörte Sprecher: Makro-F1 {macro_f1:.2f}, richtige Mundformen {percent:.0f} %</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>unit</source>
            <translation>Einheit</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/words_view.py" />
            <source>units</source>
            <translation>Einheiten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Unsaved changes</source>
            <translation>Ungespeicherte Änderungen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Unsaved labels</source>
            <translation>Ungespeicherte Beschriftungen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Unsaved words</source>
            <translation>Ungespeicherte Wörter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>use and save as…</source>
            <translation>benutzen und speichern…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Use as a Take of</source>
            <translation>Als Take benutzen von</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/welcome.py" />
            <source>Use My Microphone</source>
            <translation>Mein Mikrofon benutzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Use the new preset</source>
            <translation>Das neue Preset benutzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>use the new preset</source>
            <translation>neues Preset benutzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Use what was found; Ctrl+Z takes it back</source>
            <translation>Das Gefundene übernehmen; Strg+Z nimmt es zurück</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Uyghur</source>
            <translation>Uigurisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Uzbek</source>
            <translation>Usbekisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>variable</source>
            <translation>Variable</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>variable {name}</source>
            <translation>Variable {name}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Variable:</source>
            <translation>Variable:</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/variables_panel.py" />
            <source>variables</source>
            <translation>Variablen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/waveform_view.py" />
            <source>vertical scale of the waveform</source>
            <translation>senkrechter Maßstab der Wellenform</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/waveform_view.py" />
            <source>Vertical scale: enlarges quiet sound, in dB</source>
            <translation>Senkrechter Maßstab: vergrößert leisen Klang, in dB</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Vietnamese (Central)</source>
            <translation>Vietnamesisch (Mitte)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Vietnamese (Northern)</source>
            <translation>Vietnamesisch (Norden)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Vietnamese (Southern)</source>
            <translation>Vietnamesisch (Süden)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>views stand still</source>
            <translation>die Ansichten stehen still</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Voice</source>
            <translation>Stimme</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>voice</source>
            <translation>Stimme</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Voice &amp;&amp; Face…</source>
            <translation>Stimme &amp;&amp; Gesicht…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>voice by {speaker}</source>
            <translation>Stimme: {speaker}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>voice, rate and mouth of a spoken text</source>
            <translation>Stimme, Tempo und Mund eines gesprochenen Textes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>volume</source>
            <translation>Lautstärke</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Volume in dB; click for the output device and the speed</source>
            <translation>Lautstärke in dB; klicken für Ausgabegerät und Tempo</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Volume {volume:.0f} dB</source>
            <translation>Lautstärke {volume:.0f} dB</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/tone_bar.py" />
            <source>Vowel</source>
            <translation>Vokal</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>vowel</source>
            <translation>Vokal</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>vowel-triphone</source>
            <translation>Vokal-Triphon</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>waiting</source>
            <translation>wartet</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>waiting for the first sound from {microphone}</source>
            <translation>wartet auf den ersten Klang von {microphone}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/welcome.py" />
            <source>Watch the Demo</source>
            <translation>Demo ansehen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/microphone_bar.py" />
            <source>WAV, RF64 beyond 4 GB</source>
            <translation>WAV, RF64 über 4 GB</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/waveform_view.py" />
            <source>Waveform</source>
            <translation>Wellenform</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>WebAssembly and an AudioWorklet, and a page with a talking head</source>
            <translation>WebAssembly und ein AudioWorklet, und eine Seite mit einem sprechenden Kopf</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>weights of 15 visemes</source>
            <translation>Gewichte von 15 Visemen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Welsh</source>
            <translation>Walisisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>what a sound becomes</source>
            <translation>was aus einem Klang wird</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>What became of the file meanwhile</source>
            <translation>Was inzwischen aus der Datei wurde</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/viseme_panel.py" />
            <source>what becomes of everything else when a slider is pulled</source>
            <translation>was aus allem anderen wird, wenn ein Regler gezogen wird</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/viseme_panel.py" />
            <source>What becomes of the speech, of the other shapes and of blinks when a slider asks for a shape: all stay, and movements add up; all but blinks go to 0; blinks as well; or first the speech and then other shapes shrink, so that all are 100 % at most. Keys and buttons set all but blinks to 0 while they are held</source>
            <translation>Was aus der Sprache, den anderen Formen und dem Blinzeln wird, wenn ein Regler eine Form verlangt: Alle bleiben, und Bewegungen addieren sich; alle außer dem Blinzeln gehen auf 0; auch das Blinzeln; oder erst die Sprache und dann andere Formen schrumpfen, sodass alle zusammen höchstens 100 % sind. Tasten und Schaltflächen setzen, solange sie gehalten werden, alles außer dem Blinzeln auf 0</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/banner.py" />
            <source>What can be done about it</source>
            <translation>Was sich dagegen tun lässt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_model.py" />
            <source>What else was there is kept, such as {name}.</source>
            <translation>Was sonst da war, bleibt erhalten, zum Beispiel {name}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>What is drawn over the sonagram, and below it: formants, pitch, level, words</source>
            <translation>Was über dem Sonagramm und darunter gezeichnet wird: Formanten, Grundfrequenz, Pegel, Wörter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/scroll_view.py" />
            <source>what is heard over time</source>
            <translation>was über die Zeit gehört wird</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>What is said from {start:.3f} to {end:.3f} s:</source>
            <translation>Was von {start:.3f} bis {end:.3f} s gesagt wird:</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>What is said there:</source>
            <translation>Was dort gesagt wird:</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/words_view.py" />
            <source>what is said when</source>
            <translation>was wann gesagt wird</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>What is said, or is to be said: Ctrl+Return says it, Ctrl+Shift+Return aligns it with the sound</source>
            <translation>Was gesagt wird oder werden soll: Strg+Return spricht es, Strg+Umschalt+Return richtet es am Klang aus</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>What Is This?</source>
            <translation>Was ist das?</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/head_pair.py" />
            <source>what moves the head</source>
            <translation>was den Kopf bewegt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>what moves the mouth</source>
            <translation>was den Mund bewegt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>what shapes the variables</source>
            <translation>was die Variablen formt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>What the chosen take is: choose another sound to relabel it</source>
            <translation>Was der gewählte Take ist: einen anderen Laut wählen, um ihn umzubenennen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/selection_dialogs.py" />
            <source>what was measured</source>
            <translation>Messwerte</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/take_list.py" />
            <source>What was said</source>
            <translation>Was gesagt wurde</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_view.py" />
            <source>Wheel: zoom at the pointer. Drag: scroll. Click: go there. Shift+drag: select. Home, End: the ends.</source>
            <translation>Rad: am Zeiger zoomen. Ziehen: verschieben. Klick: dorthin gehen. Umschalt+Ziehen: auswählen. Pos1, Ende: zu den Enden.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>where expressions are listened for</source>
            <translation>wo auf Ausdrücke gehört wird</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Where recordings go</source>
            <translation>Wohin Aufnahmen kommen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/ship_dialog.py" />
            <source>Where the ear goes</source>
            <translation>Wohin das Ohr kommt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Where the new files go</source>
            <translation>Wohin die neuen Dateien kommen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Where the sound comes from</source>
            <translation>Woher der Klang kommt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/tone_bar.py" />
            <source>Where the sweep begins</source>
            <translation>Wo der Gleitton beginnt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/tone_bar.py" />
            <source>Where the sweep ends</source>
            <translation>Wo der Gleitton endet</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/take_list.py" />
            <source>Whether it is good enough to calibrate with</source>
            <translation>Ob er gut genug zum Kalibrieren ist</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Which channel of the file is analysed</source>
            <translation>Welcher Kanal der Datei analysiert wird</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table/choices_panel.py" />
            <source>Which mouth shape each phoneme has, and which movestates make it</source>
            <translation>Welche Mundform jedes Phonem hat und welche Movestates sie bilden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Which of several recordings of the same sounds are taken</source>
            <translation>Welche von mehreren Aufzeichnungen derselben Laute genommen werden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Whisper base and network</source>
            <translation>Whisper base und Netz</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>white noise</source>
            <translation>weißes Rauschen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/take_list.py" />
            <source>Who said it</source>
            <translation>Wer es gesagt hat</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Who says the takes that are recorded from now on</source>
            <translation>Wer die Takes spricht, die von jetzt an aufgenommen werden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Who says the text, how fast, and what moves the mouth (now: {who}; {moved})</source>
            <translation>Wer den Text spricht, wie schnell, und was den Mund bewegt (jetzt: {who}; {moved})</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Who says the text: a voice of espeak-ng, or a text-to-speech program of your own</source>
            <translation>Wer den Text spricht: eine Stimme von espeak-ng oder ein eigenes Sprachprogramm</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Whose words of the labels are taken</source>
            <translation>Wessen Wörter aus den Labels übernommen werden</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Window</source>
            <translation>Fenster</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>window</source>
            <translation>Fenster</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/shortcuts.py" />
            <source>Wireframe</source>
            <translation>Drahtgitter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/head_pair.py" />
            <source>wireframe</source>
            <translation>Drahtgitter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>With a Table of Recorded Faces</source>
            <translation>Mit einer Tabelle aufgezeichneter Gesichter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>With Letters of Pinyin</source>
            <translation>Mit Pinyin-Buchstaben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>With Sounds, by the Mouth Table</source>
            <translation>Mit Lauten, nach der Mundtabelle</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>woman</source>
            <translation>Frau</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>word</source>
            <translation>Wort</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>words</source>
            <translation>Wörter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Words and Phones…</source>
            <translation>Wörter und Phone…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>words or text beside each sound</source>
            <translation>Wörter oder Text neben jedem Klang</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/sources.py" />
            <source>Write a text on the page Talk, and press Ctrl+Return there</source>
            <translation>Auf der Seite Sprechen einen Text schreiben und dort Strg+Return drücken</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Write Labels for Audacity (txt)</source>
            <translation>Beschriftungen für Audacity schreiben (txt)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Write Labels for Praat (TextGrid)</source>
            <translation>Beschriftungen für Praat schreiben (TextGrid)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/model.py" />
            <source>write one for it, as your own table</source>
            <translation>eine dafür schreiben, als eigene Tabelle</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/microphone_bar.py" />
            <source>Write the Phonemes Beside It (.csv)</source>
            <translation>Phoneme daneben schreiben (.csv)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Zoom to Selection</source>
            <translation>Auf die Auswahl zoomen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Zoom to the Whole File</source>
            <translation>Die ganze Datei zeigen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{about}, its channels cancel each other out when mixed; channel {number} is turned over</source>
            <translation>{about}, Kanäle löschen sich beim Mischen aus; Kanal {number} umgepolt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{about}, only channel {number} of {n} sounds and is used</source>
            <translation>{about}, nur Kanal {number} von {n} enthält Ton und wird verwendet</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{about}, only the channels {numbers} of {n} sound and are mixed</source>
            <translation>{about}, nur die Kanäle {numbers} von {n} enthalten Ton und werden gemischt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{about}, the recording peaks at {peak} dBFS; amplified by {gain} dB for recognition</source>
            <translation>{about}, Spitzenpegel {peak} dBFS; zur Erkennung um {gain} dB verstärkt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>{cause} at {seconds} s of {sound}</source>
            <translation>{cause} bei {seconds} s von {sound}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/phoneme_view.py" />
            <source>{changes:.1f} changes/s</source>
            <translation>{changes:.1f} Wechsel/s</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>{file} has changed on the disk since it was opened; click to open it again</source>
            <translation>{file} hat sich auf der Platte geändert, seit sie geöffnet wurde; ein Klick öffnet sie neu</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>{file} is no longer where it was; what is seen of it stays</source>
            <translation>{file} ist nicht mehr, wo sie war; was davon zu sehen ist, bleibt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>{first} and {last}</source>
            <translation>{first} und {last}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>{first} and {second} differ in {share:.1f} % of what is seen</source>
            <translation>{first} und {second} weichen in {share:.1f} % des Sichtbaren ab</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/words_view.py" />
            <source>{kind} [{names}] of {recording}, {start:.2f} to {end:.2f} s.</source>
            <translation>{kind} [{names}] aus {recording}, {start:.2f} bis {end:.2f} s.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/variables_panel.py" />
            <source>{kind} of {low:.0f}–{high:.0f} Hz of the {source} spectrum, separates {separation:.0%}</source>
            <translation>{kind} von {low:.0f}–{high:.0f} Hz im Spektrum ({source}), trennt zu {separation:.0%}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/scripts.py" />
            <source>{labels}: it is beside the sound and would be replaced; choose another name for the sound</source>
            <translation>{labels}: Die Datei liegt neben dem Klang und würde ersetzt; anderen Namen für den Klang wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/face_model.py" />
            <source>{mesh}: this mesh has no movestates; choose its .3dm file together with it</source>
            <translation>{mesh}: Dieses Netz hat keine Movestates; seine .3dm-Datei mit ihm zusammen wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{microphone} has gone</source>
            <translation>{microphone} ist weg</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>{minutes:.1f} min in {n} recordings</source>
            <translation>{minutes:.1f} min in {n} Aufnahmen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>{ms:.0f} ms ahead</source>
            <translation>{ms:.0f} ms voraus</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>{ms:.0f} ms late here</source>
            <translation>hier {ms:.0f} ms verspätet</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>{ms:.0f} ms late, {judgement}</source>
            <translation>{ms:.0f} ms verspätet, {judgement}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>{ms:.0f} ms of it are the microphone's, and the status line now counts with them</source>
            <translation>{ms:.0f} ms davon fallen auf das Mikrofon, und die Statuszeile rechnet jetzt damit</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/microphone_bar.py" />
            <source>{name} (not there)</source>
            <translation>{name} (nicht da)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>{name} hears the bare sound: the filters shape only what is seen</source>
            <translation>{name} hört den bloßen Klang: Die Filter formen nur, was zu sehen ist</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>{name} is there already.</source>
            <translation>{name} ist schon vorhanden.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>{name}, {rate:g} syllables a second</source>
            <translation>{name}, {rate:g} Silben pro Sekunde</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name}: it is cut off behind its sound, which is whole</source>
            <translation>{name}: hinter dem Ton abgeschnitten; der Ton ist vollständig</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name}: it is cut off: of the {announced} s that its header announces, {there} s are there</source>
            <translation>{name}: abgeschnitten; von angekündigten {announced} s sind {there} s vorhanden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name}: its header does not say how long it is; {there} s are there</source>
            <translation>{name}: Der Header nennt keine Länge; vorhanden sind {there} s</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name}: reading it is not permitted; change its permissions or copy it</source>
            <translation>{name}: Lesen ist nicht erlaubt; die Rechte ändern oder die Datei kopieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name}: the file is empty (0 bytes); copy or record it again</source>
            <translation>{name}: Die Datei ist leer (0 Bytes); noch einmal kopieren oder aufnehmen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name}: there are no samples in it; record or export it again</source>
            <translation>{name}: Es sind keine Abtastwerte darin; noch einmal aufnehmen oder exportieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name}: there is no such file; check its name and folder</source>
            <translation>{name}: Diese Datei gibt es nicht; Name und Ordner prüfen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/model.py" />
            <source>{name}: this face has none of the table's movestates; {known}.</source>
            <translation>{name}: Dieses Gesicht hat keine der Movestates der Tabelle; {known}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name}: this is a folder, not a sound file; choose a file in it</source>
            <translation>{name}: Das ist ein Ordner, keine Klangdatei; eine Datei darin wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name}: this is not a sound file that can be read; choose a WAV, AIFF, FLAC, OGG, MP3 or M4A file</source>
            <translation>{name}: keine lesbare Klangdatei; WAV, AIFF, FLAC, OGG, MP3 oder M4A wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name}: this kind of file needs the package av, which is not installed; install it with: {command}</source>
            <translation>{name}: Für diese Dateien fehlt das Paket av; installieren mit: {command}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name}; its channels cancel each other out when mixed, so choose one of them</source>
            <translation>{name}; Kanäle löschen sich beim Mischen aus, einen davon wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>{n} by 1 speaker</source>
            <translation>{n} von 1 Sprecher</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>{n} by {speakers} speakers</source>
            <translation>{n} von {speakers} Sprechern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/sources.py" />
            <source>{n} channels</source>
            <translation>{n} Kanäle</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{n} conditions of the rules for {phonemes} compare {variable} with this</source>
            <translation>{n} Bedingungen der Regeln für {phonemes} vergleichen {variable} hiermit</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/dialogs.py" />
            <source>{n} deleted takes</source>
            <translation>{n} gelöschte Takes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>{n} files are there already, such as {name}.</source>
            <translation>{n} Dateien sind schon vorhanden, etwa {name}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>{n} fit badly</source>
            <translation>{n} passen schlecht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>{n} fits badly</source>
            <translation>{n} passt schlecht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>{n} frames not drawn</source>
            <translation>{n} Frames nicht gezeichnet</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>{n} frames{since}; {front_end}</source>
            <translation>{n} Frames{since}; {front_end}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_model.py" />
            <source>{n} label files for {program} lie beside the takes in {folder}.</source>
            <translation>{n} Beschriftungsdateien für {program} liegen neben den Takes in {folder}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_model.py" />
            <source>{n} labelled recordings were loaded.</source>
            <translation>{n} beschriftete Aufnahmen wurden geladen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>{n} labels</source>
            <translation>{n} Beschriftungen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>{n} of 10 sounds</source>
            <translation>{n} von 10 Lauten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>{n} points</source>
            <translation>{n} Punkte</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_model.py" />
            <source>{n} sounds were left out; {refusal}</source>
            <translation>{n} Klänge wurden ausgelassen; {refusal}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>{n} word</source>
            <translation>{n} Wort</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>{n} words</source>
            <translation>{n} Wörter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>{output} is the WAV file that it shall write, {text} the text; without {text}, the program reads the text from its standard input. A TextGrid that it writes beside the sound tells the times.</source>
            <translation>{output} ist die WAV-Datei, die es schreiben soll, {text} der Text; ohne {text} liest das Programm den Text von seiner Standardeingabe. Ein TextGrid, das es neben den Klang schreibt, sagt die Zeiten.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/app.py" />
            <source>{out}: the picture cannot be written; choose another place with -o</source>
            <translation>{out}: Das Bild kann nicht geschrieben werden; mit -o einen anderen Ort wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>{path} cannot hold {listed} of this preset. Save all of it as a TOML file?</source>
            <translation>{path} kann Folgendes aus diesem Preset nicht fassen: {listed}. Alles als TOML-Datei speichern?</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>{path} is shown beside the speech; do without it</source>
            <translation>{path} wird neben der Sprache gezeigt; darauf verzichten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>{path} says how words are pronounced; do without it</source>
            <translation>{path} sagt, wie Wörter ausgesprochen werden; darauf verzichten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/plot_menu.py" />
            <source>{path}: cannot be written ({fault}); choose another folder</source>
            <translation>{path}: kann nicht geschrieben werden ({fault}); einen anderen Ordner wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/scripts.py" />
            <source>{path}: cannot be written ({reason_of}); choose another folder</source>
            <translation>{path}: kann nicht geschrieben werden ({reason_of}); einen anderen Ordner wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/phoneme_view.py" />
            <source>{percent:.0f} % sure</source>
            <translation>{percent:.0f} % sicher</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/spectrum_view.py" />
            <source>{plot}: amplitude scale</source>
            <translation>{plot}: Amplitudenmaßstab</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/ship_dialog.py" />
            <source>{preset}, as it is in hand</source>
            <translation>{preset}, wie es gerade ist</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>{recogniser} never waits</source>
            <translation>{recogniser} wartet nie</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{recogniser}, {ms} ms ahead</source>
            <translation>{recogniser}, {ms} ms voraus</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/original_model.py" />
            <source>{recording}, as recorded: {title}</source>
            <translation>{recording}, wie aufgezeichnet: {title}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{rest}, only channel {k} of {n} is used</source>
            <translation>{rest}, nur Kanal {k} von {n} wird benutzt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{rest}, shorter than one window ({ms} ms), so silence surrounds it</source>
            <translation>{rest}, kürzer als ein Fenster ({ms} ms), daher von Stille umgeben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{rest}, {n} channels are mixed to one</source>
            <translation>{rest}, {n} Kanäle zu einem gemischt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{room} of the room is called silence</source>
            <translation>{room} des Raums heißen Stille</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{room} of the room is called silence, and {speech} of the speech in the takes</source>
            <translation>{room} des Raums heißen Stille, und {speech} der Sprache in den Takes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/confusion_view.py" />
            <source>{said} recognised as {taken}: {count} frames of 10 ms, {share:.1%} of {said}</source>
            <translation>{said} erkannt als {taken}: {count} Frames von 10 ms, {share:.1%} von {said}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>{said}; boundaries fixed by the voice</source>
            <translation>{said}; Grenzen von der Stimme vorgegeben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>{seconds:.1f} s could not be heard</source>
            <translation>{seconds:.1f} s waren nicht zu hören</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>{seconds:.1f} s, recordings: {n}</source>
            <translation>{seconds:.1f} s, Aufnahmen: {n}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>{seconds:.2f} s lost</source>
            <translation>{seconds:.2f} s verloren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_panel.py" />
            <source>{share:.1f} % differ</source>
            <translation>{share:.1f} % anders</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>{start:.2f} to {end:.2f} s: {said} is said, {recognised} was recognised</source>
            <translation>{start:.2f} bis {end:.2f} s: gesagt {said}, erkannt {recognised}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/take_waveform.py" />
            <source>{start:.2f} – {end:.2f} s of {duration:.2f} s</source>
            <translation>{start:.2f} – {end:.2f} s von {duration:.2f} s</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/selection_dialogs.py" />
            <source>{start:.3f} to {end:.3f} s of {sound}</source>
            <translation>{start:.3f} bis {end:.3f} s von {sound}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/take_list.py" />
            <source>{take} is left out: {reason}</source>
            <translation>{take} zählt nicht: {reason}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/export_queue.py" />
            <source>{target}: {n} bytes that are no text</source>
            <translation>{target}: {n} Bytes, die kein Text sind</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{trouble}; trying again every 2 s</source>
            <translation>{trouble}; alle 2 s ein neuer Versuch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>{url}: only files on this computer can be opened; save it here first</source>
            <translation>{url}: Nur Dateien auf diesem Computer lassen sich öffnen; zuerst hier speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>Δ is how differently it is shaped from the averaged spectrum, whatever the loudness</source>
            <translation>Δ sagt, wie anders es geformt ist als das gemittelte Spektrum, unabhängig von der Lautstärke</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>▶ new preset</source>
            <translation>▶ neues Preset</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>▶ old preset</source>
            <translation>▶ altes Preset</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>◀ back</source>
            <translation>◀ zurück</translation>
        </message>
    </context>
</TS>
