<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
    <context>
        <name>PhonemeAnalyser</name>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source> ({reason})</source>
            <translation> ({reason})</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/score_strip.py" />
            <source> and the open file</source>
            <translation> und die offene Datei</translation>
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
            <source>&amp;Talk</source>
            <translation>&amp;Sprechen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>&amp;View</source>
            <translation>A&amp;nsicht</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/inspection/averaged_spectrum.py" />
            <source>'sound' in the header must be [path, channel, [[start, end], ...]], found {strip}</source>
            <translation>'sound' im Kopf muss [Pfad, Kanal, [[Anfang, Ende], ...]] sein, gefunden: {strip}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/inspection/averaged_spectrum.py" />
            <source>'{key}' in the header must be a whole number of 0 or more, found {text}</source>
            <translation>'{key}' in den Kopfdaten muss eine ganze Zahl ab 0 sein, gefunden {text}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>({n} more are in {folder})</source>
            <translation>({n} weitere sind in {folder})</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/conversion/spoken_texts.py" />
            <source>--speaker goes with a --script that tells speakers apart: a .TextGrid or .json</source>
            <translation>--speaker gehört zu einem --script, das Sprecher unterscheidet: .TextGrid oder .json</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/conversion/spoken_texts.py" />
            <source>--text-feeling goes with --text or --script: give the text that is spoken</source>
            <translation>--text-feeling gehört zu --text oder --script: den gesprochenen Text angeben</translation>
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
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_model.py" />
            <source>1 audio file was skipped: {refusal}</source>
            <translation>1 Audiodatei wurde übersprungen: {refusal}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>1 curve of {seconds:.1f} s of sound</source>
            <translation>1 Kurve aus {seconds:.1f} s Ton</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/curves.py" />
            <source>1 curve saved as {target}</source>
            <translation>1 Kurve gespeichert als {target}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_model.py" />
            <source>1 deleted take removed from the disk.</source>
            <translation>1 gelöschter Take vom Datenträger entfernt.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_model.py" />
            <source>1 label file for {program} written to {folder}.</source>
            <translation>1 Beschriftungsdatei für {program} in {folder} geschrieben.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_model.py" />
            <source>1 labelled recording was loaded.</source>
            <translation>1 beschriftete Aufnahme wurde geladen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/score_strip.py" />
            <source>1 recording</source>
            <translation>1 Aufnahme</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_editor.py" />
            <source>1 rule needs attention (⚠).</source>
            <translation>1 Regel prüfen (⚠).</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/serve_dialog.py" />
            <source>16 to 256 letters, digits or . _ ~ -</source>
            <translation>16 bis 256 Buchstaben, Ziffern oder . _ ~ -</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/figures_table.py" />
            <source>95 % interval of chance: {low:+.1f} to {high:+.1f}</source>
            <translation>95-%-Intervall des Zufalls: {low:+.1f} bis {high:+.1f}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_view.py" />
            <source>&lt;b&gt;File&lt;/b&gt;</source>
            <translation>&lt;b&gt;Datei&lt;/b&gt;</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_view.py" />
            <source>&lt;b&gt;History&lt;/b&gt;</source>
            <translation>&lt;b&gt;Verlauf&lt;/b&gt;</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>&lt;b&gt;No clear difference&lt;/b&gt;: macro F1 {gain} points higher for {letter} ({low} to {high}).</source>
            <translation>&lt;b&gt;Kein klarer Unterschied&lt;/b&gt;: Makro-F1 von {letter} um {gain} Punkte höher ({low} bis {high}).</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>&lt;b&gt;PhonemeAnalyser&lt;/b&gt;&lt;p&gt;Calibrates real-time phoneme recognition for lip sync, and shows why a phoneme was recognised.&lt;p&gt;Version {version}, MIT licence; &lt;i&gt;Help &amp;gt; Licences&lt;/i&gt; lists all components. The demo is a synthetic voice of the Festival project (CMU slt). The heads are made from MakeHuman's mesh and targets, and face units by Mika Suominen (CC0).&lt;p&gt;&lt;b&gt;The preset Learned.&lt;/b&gt; {summary}</source>
            <translation>&lt;b&gt;PhonemeAnalyser&lt;/b&gt;&lt;p&gt;Kalibriert die Phonemerkennung in Echtzeit für Lippensynchronisation und zeigt, warum ein Phonem erkannt wurde.&lt;p&gt;Version {version}, MIT-Lizenz; &lt;i&gt;Hilfe &amp;gt; Lizenzen&lt;/i&gt; nennt alle Bestandteile. Die Demo ist eine künstliche Stimme des Festival-Projekts (CMU slt). Die Köpfe sind aus Netz und Targets von MakeHuman und Gesichtseinheiten von Mika Suominen gemacht (CC0).&lt;p&gt;&lt;b&gt;Das Preset Learned.&lt;/b&gt; {summary}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>&lt;b&gt;Recording {phoneme}&lt;/b&gt;: release to finish</source>
            <translation>&lt;b&gt;{phoneme} wird aufgenommen&lt;/b&gt;: zum Beenden loslassen</translation>
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
            <location filename="../../../phonemeanalyser/desktop/welcome.py" />
            <source>&lt;b&gt;What would you like to do first?&lt;/b&gt;</source>
            <translation>&lt;b&gt;Womit soll es losgehen?&lt;/b&gt;</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>&lt;b&gt;{letter} is better&lt;/b&gt;: macro F1 {gain} points higher (95 % interval {low} to {high}).</source>
            <translation>&lt;b&gt;{letter} ist besser&lt;/b&gt;: Makro-F1 um {gain} Punkte höher (95-%-Intervall {low} bis {high}).</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>&lt;b&gt;{start} – {end}&lt;/b&gt;: choose a phoneme</source>
            <translation>&lt;b&gt;{start} – {end}&lt;/b&gt;: Phonem wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>&lt;b&gt;{truth}&lt;/b&gt; recognised as &lt;b&gt;{answer}&lt;/b&gt; · segments: {n} ({seconds:.2f} s)</source>
            <translation>&lt;b&gt;{truth}&lt;/b&gt; erkannt als &lt;b&gt;{answer}&lt;/b&gt; · Segmente: {n} ({seconds:.2f} s)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/preset_choice.py" />
            <source>&lt;p&gt;Best model that files are recognised with.&lt;/p&gt;&lt;p&gt;&lt;i&gt;Real-time&lt;/i&gt;: the preset's recogniser, as for a microphone.&lt;br&gt;&lt;i&gt;Encoder&lt;/i&gt;: the real-time model with the encoder.&lt;br&gt;&lt;i&gt;Offline&lt;/i&gt;: a network with half a second of context on both sides.&lt;br&gt;&lt;i&gt;Whisper&lt;/i&gt;: the offline model and a speech encoder, where a whole file is recognised at once: saving, exporting, aligning with its text. Playback uses the offline model.&lt;/p&gt;&lt;p&gt;Models that are not available are grey and say why.&lt;/p&gt;</source>
            <translation>&lt;p&gt;Bestes Modell, mit dem Dateien erkannt werden.&lt;/p&gt;&lt;p&gt;&lt;i&gt;Echtzeit&lt;/i&gt;: der Erkenner des Presets, wie beim Mikrofon.&lt;br&gt;&lt;i&gt;Encoder&lt;/i&gt;: das Echtzeitmodell mit dem Encoder.&lt;br&gt;&lt;i&gt;Offline&lt;/i&gt;: ein Netz mit einer halben Sekunde Kontext auf beiden Seiten.&lt;br&gt;&lt;i&gt;Whisper&lt;/i&gt;: das Offline-Modell mit einem Sprach-Encoder, wo eine ganze Datei auf einmal erkannt wird: beim Speichern, Exportieren und Ausrichten an ihrem Text. Beim Abspielen gilt das Offline-Modell.&lt;/p&gt;&lt;p&gt;Nicht verfügbare Modelle sind grau und sagen, warum.&lt;/p&gt;</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/phoneme_data_panel.py" />
            <source>&lt;p&gt;Each number with its variable and comparison. Below each other: the sounds for which the comparison should hold, and those for which it should fail, with the smallest, mean and largest value of the variable for each speaker.&lt;/p&gt;&lt;p&gt;Click a value, or press Return on it, to use it as the number; double-click a number, or press Return on it, to type.&lt;/p&gt;</source>
            <translation>&lt;p&gt;Jede Zahl mit ihrer Variablen und ihrem Vergleich. Untereinander: die Laute, für die der Vergleich zutreffen soll, und die, für die er nicht zutreffen soll, mit kleinstem, mittlerem und größtem Wert der Variablen für jeden Sprecher.&lt;/p&gt;&lt;p&gt;Ein Klick auf einen Wert oder die Eingabetaste übernimmt ihn als Zahl; ein Doppelklick auf eine Zahl oder die Eingabetaste lässt sie eingeben.&lt;/p&gt;</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>&lt;p&gt;Macro F1 is the mean of the F1 scores of those of the ten phonemes that occur in the labels. More changes per second than in the labels are flicker.&lt;/p&gt;&lt;p&gt;Takes and recordings are recognised by the real-time model, which is the one you calibrate; files that you open may be analysed with a better file model.&lt;/p&gt;</source>
            <translation>&lt;p&gt;Makro-F1 ist der Mittelwert der F1-Werte derjenigen der zehn Phoneme, die in der Beschriftung vorkommen. Mehr Wechsel pro Sekunde als in der Beschriftung sind Flackern.&lt;/p&gt;&lt;p&gt;Takes und Aufnahmen erkennt hier das Echtzeitmodell, das kalibriert wird; geöffnete Dateien werden vielleicht mit einem besseren Modell für Dateien analysiert.&lt;/p&gt;</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/preset_choice.py" />
            <source>&lt;p&gt;Model that recognises the microphone.&lt;/p&gt;&lt;p&gt;&lt;i&gt;Small network&lt;/i&gt;: next to no processor load, any look-ahead.&lt;br&gt;&lt;i&gt;Encoder&lt;/i&gt;: the lower layers of a speech encoder, trained on very many voices, together with the small network; look-ahead 20 or 40 ms, a few percent of a processor core.&lt;/p&gt;&lt;p&gt;Models that are not available are grey and say why.&lt;/p&gt;</source>
            <translation>&lt;p&gt;Modell, mit dem das Mikrofon erkannt wird.&lt;/p&gt;&lt;p&gt;&lt;i&gt;Kleines Netz&lt;/i&gt;: kaum Rechenlast, beliebige Vorausschau.&lt;br&gt;&lt;i&gt;Encoder&lt;/i&gt;: die unteren Schichten eines Sprach-Encoders, der mit sehr vielen Stimmen trainiert wurde, zusammen mit dem kleinen Netz; Vorausschau 20 oder 40 ms, wenige Prozent eines Prozessorkerns.&lt;/p&gt;&lt;p&gt;Nicht verfügbare Modelle sind grau und sagen, warum.&lt;/p&gt;</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/distribution.py" />
            <source>&lt;p&gt;One row per phoneme: histogram, box from quartile to quartile, median, and a line from minimum to maximum.&lt;/p&gt;&lt;p&gt;Drag a threshold, or move it with Left and Right (Shift: in finer steps); Up and Down select one. Click a number to make it the value of the threshold.&lt;/p&gt;</source>
            <translation>&lt;p&gt;Eine Zeile je Phonem: Histogramm, Kasten von Quartil zu Quartil, Median und eine Linie von Minimum bis Maximum.&lt;/p&gt;&lt;p&gt;Schwelle ziehen oder mit Links und Rechts verschieben (Umschalt: feiner); Auf und Ab wählen eine aus. Klick auf eine Zahl: Schwelle auf diesen Wert setzen.&lt;/p&gt;</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/expression/streams.py" />
            <source>[classes] has {arkit} twice; name it once</source>
            <translation>In [classes] steht {arkit} zweimal; nur einmal angeben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/expression/streams.py" />
            <source>[classes] lacks {missing}; put each blend shape into a class</source>
            <translation>In [classes] fehlt {missing}; jedem Blendshape eine Klasse geben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/presets/preset.py" />
            <source>[judged] day is a date such as 2026-11-25, found {day}; correct it</source>
            <translation>[judged] day ist ein Datum wie 2026-11-25, gefunden: {day}; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/table.py" />
            <source>[manner] {idle} acts on nothing, since [times] names every phoneme; remove one of them</source>
            <translation>[manner] {idle} hat keine Wirkung, weil [times] alle Phoneme nennt; eins von beiden entfernen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/speech/pinyin/table.py" />
            <source>[marks] names {mark}, which is no punctuation mark; remove it</source>
            <translation>[marks] nennt {mark}, das kein Satzzeichen ist; entfernen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/table.py" />
            <source>[phonemes] lacks {label}; name its mouth shape</source>
            <translation>In [phonemes] fehlt {label}; seine Mundform angeben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/poses.py" />
            <source>[phones] says twice what {name} is; remove one</source>
            <translation>[phones] beschreibt {name} zweimal; eins entfernen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/speech/pinyin/table.py" />
            <source>[shapes] lacks {rest}, the mouth at rest; add [shapes."{rest_2}"]</source>
            <translation>In [shapes] fehlt {rest}, der Mund in Ruhe; [shapes."{rest_2}"] hinzufügen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/table.py" />
            <source>[times] silence has none: the mouth closes in the release of what was said before; remove it</source>
            <translation>[times] silence hat keine Zeiten: Der Mund schließt sich im Ausklang des vorigen Lauts; Eintrag entfernen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/feelings.py" />
            <source>[{words}]: a feeling is shown by 0..1, found {entry}; correct it</source>
            <translation>[{words}]: Ein Gefühl wird mit 0..1 gezeigt, gefunden: {entry}; berichtigen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/feelings.py" />
            <source>[{words}]: neutral goes with no other feeling; leave one of them out</source>
            <translation>[{words}]: neutral verträgt kein anderes Gefühl; eines davon weglassen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/feelings.py" />
            <source>[{words}]: there is no feeling {entry}; {lexicon}</source>
            <translation>[{words}]: Es gibt kein Gefühl {entry}; {lexicon}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/feelings.py" />
            <source>[{words}]: {name} is asked for by {shares} and by {share}; keep one</source>
            <translation>[{words}]: {name} ist mit {shares} und mit {share} angegeben; nur eines davon behalten</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/threedm.py" />
            <source>a .3dm file begins with 3dm01, this does not; choose another file</source>
            <translation>Eine .3dm-Datei beginnt mit 3dm01, diese nicht; andere Datei wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/threedm.py" />
            <source>a .3dma file begins with a line {title}, this does not; choose another file</source>
            <translation>Eine .3dma-Datei beginnt mit einer Zeile {title}, diese nicht; andere Datei wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/x_file.py" />
            <source>a .x file begins with 'xof 03', this does not; choose another file</source>
            <translation>Eine .x-Datei beginnt mit 'xof 03', diese nicht; andere Datei wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>A and E</source>
            <translation>A und E</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/style.py" />
            <source>a blend</source>
            <translation>eine Mischung</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/storage/files.py" />
            <source>a body of {file_size} bytes</source>
            <translation>ein Textkörper von {file_size} Byte</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/utterance.py" />
            <source>a boundary at {seconds} s would leave nothing of a {unit}; choose another place</source>
            <translation>Eine Grenze bei {seconds} s ließe nichts übrig von: {unit}; andere Stelle wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/recognition/model.py" />
            <source>a centred model has one head and uses {most_frames_around} frames around; get it anew</source>
            <translation>Ein zentriertes Modell hat einen Kopf und sieht {most_frames_around} Frames zu beiden Seiten; neu beschaffen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/presets/document.py" />
            <source>a condition of a rule is a variable, a comparison and a number, such as m_a1 &lt; 3.5; found {text}</source>
            <translation>Eine Regelbedingung besteht aus Variable, Vergleich und Zahl, etwa m_a1 &lt; 3.5; gefunden {text}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/recognition/scores.py" />
            <source>a confidence has 1..{most_points} rising scores and as many shares that do not fall, all of 0..1; fit it again</source>
            <translation>Eine Konfidenzkurve braucht 1..{most_points} steigende Werte und ebenso viele nicht fallende Anteile, alle in 0..1; neu anpassen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/curves_file.py" />
            <source>a cue begins at {start} s, before the last one ends; export the curves again</source>
            <translation>Ein Mundform-Eintrag beginnt bei {start} s, bevor der vorige endet; Kurven neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/curves_file.py" />
            <source>a cue begins before it ends, within {longest} s, and its intensity lies in 0..1, found {start}..{end} s, {intensity}; export the curves again</source>
            <translation>Ein Mundform-Eintrag muss vor seinem Ende beginnen, höchstens {longest} s, mit Intensität 0..1; gefunden {start}..{end} s, {intensity}; Kurven neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>a curve</source>
            <translation>eine Kurve</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/inspection/averaged_spectrum.py" />
            <source>a curve begins with the line '# {format}', this does not</source>
            <translation>Eine Kurve beginnt mit der Zeile '# {format}', diese Datei nicht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>a face</source>
            <translation>ein Gesicht</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf.py" />
            <source>a face has at most {most_states} morph targets; leave some out</source>
            <translation>Ein Gesicht hat höchstens {most_states} Morph-Targets; einige weglassen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/morph_mesh.py" />
            <source>a face has at most {most_states} movestates, this has {targets}; leave some out</source>
            <translation>Ein Gesicht hat höchstens {most_states} Blendshapes, dieses {targets}; einige weglassen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/face_learning.py" />
            <source>a face is learned from {least_seconds} s of performances and {left_out} recordings at least, found {duration} s; record more</source>
            <translation>Ein Gesicht wird aus mindestens {least_seconds} s und {left_out} Aufnahmen gelernt, gefunden wurden {duration} s; mehr aufnehmen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/face_learning.py" />
            <source>a face is learned on a real-time model with the usual visemes; choose the preset learned</source>
            <translation>Ein Gesicht wird auf einem Echtzeitmodell mit den üblichen Visemen gelernt; das Preset learned wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>a file beside a mesh</source>
            <translation>eine Datei neben einem Mesh</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/curves_file.py" />
            <source>a file of curves has the format {format}, found {form}; choose another file</source>
            <translation>Eine Kurvendatei hat das Format {format}, gefunden {form}; andere Datei wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>a file of expression channels</source>
            <translation>eine Datei mit Ausdruckskanälen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>a file of expressions</source>
            <translation>eine Datei mit Ausdrücken</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>a file of key words</source>
            <translation>eine Datei mit Schlüsselwörtern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>a file of labels</source>
            <translation>eine Beschriftungsdatei</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>a file of poses</source>
            <translation>eine Datei mit Posen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>a fit needs labels of at least two sounds, and the recordings have only {only}; load some with others</source>
            <translation>Zum Anpassen braucht es Beschriftungen von mindestens zwei Lauten, die Aufnahmen haben nur {only}; welche mit anderen laden</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/shipping/targets.py" />
            <source>a folder has at most {most_tables} mouth tables, each with a name of its own, got {paths}; leave some out</source>
            <translation>Ein Ordner fasst höchstens {most_tables} Mundtabellen mit verschiedenen Namen, gefunden {paths}; einige weglassen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/tone.py" />
            <source>a formant's bandwidth</source>
            <translation>die Bandbreite eines Formanten</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/tone.py" />
            <source>a formant's frequency</source>
            <translation>die Frequenz eines Formanten</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>a huge number</source>
            <translation>eine riesige Zahl</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>A if both hold, E if only the first</source>
            <translation>A, wenn beide gelten, E, wenn nur die erste</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/key_layer.py" />
            <source>a key lies at 0..{latest} s, found {times} s; correct it</source>
            <translation>Ein Keyframe liegt bei 0..{latest} s, gefunden {times} s; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/tiers.py" />
            <source>a label lasts {shortest} ms at least; select a longer segment</source>
            <translation>Eine Beschriftung dauert mindestens {shortest} ms; ein längeres Segment auswählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/utterance.py" />
            <source>a label must not end before it starts</source>
            <translation>Eine Beschriftung darf nicht enden, bevor es beginnt</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/tiers.py" />
            <source>a label needs a name; write the sound, or delete the label</source>
            <translation>eine Beschriftung braucht einen Text; ihn eingeben oder die Beschriftung löschen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>a lexicon</source>
            <translation>ein Lexikon</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>a list</source>
            <translation>eine Liste</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/storage/strict_table.py" />
            <source>a list of numbers within ±3.4e38</source>
            <translation>eine Liste von Zahlen in ±3.4e38</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/storage/strict_table.py" />
            <source>a list of tables</source>
            <translation>eine Liste von Tabellen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/keywords.py" />
            <source>a list of up to {most_values} numbers within ±{most}</source>
            <translation>eine Liste von bis zu {most_values} Zahlen in ±{most}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/keywords.py" />
            <source>a list of words</source>
            <translation>eine Liste von Wörtern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>a mesh</source>
            <translation>ein Mesh</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/mesh.py" />
            <source>a mesh has 1..{most_vertices} vertices, this has {points}; choose another file</source>
            <translation>Ein Mesh hat 1..{most_vertices} Eckpunkte, dieses {points}; andere Datei wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/x_file.py" />
            <source>a mesh has at most {most_materials} materials, this has {materials}; join some</source>
            <translation>Ein Mesh hat höchstens {most_materials} Materialien, dieses {materials}; einige zusammenfassen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/obj.py" />
            <source>a mesh has at most {most_materials} materials; join some</source>
            <translation>Ein Mesh hat höchstens {most_materials} Materialien; einige zusammenfassen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf.py" />
            <source>a mesh has at most {most_primitives} parts; join some</source>
            <translation>Ein Mesh hat höchstens {most_primitives} Teile; einige zusammenfassen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/obj.py" />
            <source>a mesh has at most {most_triangles} normals; make it coarser</source>
            <translation>Ein Mesh hat höchstens {most_triangles} Normalen; gröber machen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/mesh.py" />
            <source>a mesh has at most {most_triangles} triangles, this has {corners}; make it coarser</source>
            <translation>Ein Mesh hat höchstens {most_triangles} Dreiecke, dieses {corners}; gröber machen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf.py" />
            <source>a mesh has at most {most_triangles} triangles; make it coarser</source>
            <translation>Ein Mesh hat höchstens {most_triangles} Dreiecke; gröber machen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf.py" />
            <source>a mesh has at most {most_vertices} vertices; make it coarser</source>
            <translation>Ein Mesh hat höchstens {most_vertices} Eckpunkte; gröber machen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/encoder/live.py" />
            <source>a mix has a share of 0..1, a power of 0..2 and 26 priors above 0</source>
            <translation>Eine Mischung hat einen Anteil von 0..1, eine Potenz von 0..2 und 26 A-priori-Werte über 0</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/recognition/model.py" />
            <source>a model has 1..{most_layers} layers and 1..{most_frames_ahead} heads; get it anew</source>
            <translation>Ein Modell hat 1..{most_layers} Schichten und 1..{most_frames_ahead} Köpfe; neu beschaffen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/recognition/model.py" />
            <source>a model has 1..{most_warps} warps of {least_warp}..{most_warp}; get it anew</source>
            <translation>Ein Modell hat 1..{most_warps} Verzerrungen von {least_warp}..{most_warp}; neu beschaffen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/presets/document.py" />
            <source>a model lies beside its preset, so model is a plain name such as voice.npz, found {name}; correct it</source>
            <translation>Ein Modell liegt neben seinem Preset, daher ist model ein einfacher Name wie voice.npz, gefunden {name}; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>a mouth table</source>
            <translation>eine Mundtabelle</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/face_network.py" />
            <source>a network of a face is smaller than 8 MB; choose another file</source>
            <translation>Ein Netz eines Gesichts ist kleiner als 8 MB; eine andere Datei wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/exports/gltf_rotation.py" />
            <source>a node lies below itself</source>
            <translation>ein Knoten liegt unter sich selbst</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/textgrid.py" />
            <source>a number</source>
            <translation>eine Zahl</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/table.py" />
            <source>a number in {low}..{high}</source>
            <translation>eine Zahl in {low}..{high}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/recording.py" />
            <source>a number is missing, found {value}</source>
            <translation>eine Zahl fehlt, gefunden {value}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/exports/gltf_rotation.py" />
            <source>a number is too large, or none</source>
            <translation>eine Zahl ist zu groß oder keine</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/table.py" />
            <source>a number of seconds in {low}..{high}</source>
            <translation>eine Zahl von Sekunden in {low}..{high}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>a number that is not finite</source>
            <translation>eine Zahl, die nicht endlich ist</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>a number within ±3.4e38</source>
            <translation>eine Zahl in ±3.4e38</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>a part of it is said to have {size} bytes, and {length} are left; export it again</source>
            <translation>Ein Teil ist mit {size} Byte angegeben, es folgen nur {length}; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/table.py" />
            <source>a percentage in -{strongest}..{strongest_2}</source>
            <translation>ein Prozentwert in -{strongest}..{strongest_2}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/utterance.py" />
            <source>a phone of no length, at {first} s, cannot be made longer; correct the times</source>
            <translation>Ein Laut ohne Dauer, bei {first} s, lässt sich nicht verlängern; Zeiten korrigieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/preset_dialogs.py" />
            <source>A PhonemeData file holds 21 numbers only: {path} cannot store {listed} of this preset. Save the whole preset as a TOML file?</source>
            <translation>Eine PhonemeData-Datei fasst nur 21 Zahlen: {path} kann Folgendes aus diesem Preset nicht speichern: {listed}. Das ganze Preset als TOML-Datei speichern?</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/presets/files.py" />
            <source>a PhonemeData file holds {numbers} numbers and ends with {numbers_2}, found {found}; remove {word} in line {line} and what follows</source>
            <translation>Eine PhonemeData-Datei enthält {numbers} Zahlen und endet mit {numbers_2}, gefunden {found}; {word} in Zeile {line} und alles danach löschen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/presets/files.py" />
            <source>a PhonemeData file holds {numbers} numbers, found {found}; the first one missing after line {found_2} is {numbers_2}; add it</source>
            <translation>Eine PhonemeData-Datei enthält {numbers} Zahlen, gefunden {found}; nach Zeile {found_2} fehlt als erste {numbers_2}; ergänzen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_materials.py" />
            <source>a picture in its text is no base64; export it again</source>
            <translation>Ein Bild im Text ist kein Base64; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>a pinyin table</source>
            <translation>eine Pinyin-Tabelle</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/recognition/rules.py" />
            <source>a pitch set has no name; give it one, such as woman</source>
            <translation>Ein Grundfrequenz-Satz hat keinen Namen; einen angeben, etwa woman</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>a preset</source>
            <translation>ein Preset</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/preset_picker.py" />
            <source>A preset or PhonemeData file of any folder</source>
            <translation>Ein Preset oder eine PhonemeData-Datei aus einem beliebigen Ordner</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/expression/composer.py" />
            <source>a priority lies in 0..1, found {priority}; correct it</source>
            <translation>Eine Priorität liegt in 0..1, gefunden {priority}; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>a rule for {label} asks for the variable {variable}, which is not measured; add it, or change the rule</source>
            <translation>Eine Regel für {label} verwendet die Variable {variable}, die nicht gemessen wird; hinzufügen oder Regel ändern</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/skin.py" />
            <source>a scene has at most {most_nodes} nodes, got {nodes}; export less</source>
            <translation>Eine Szene hat höchstens {most_nodes} Knoten, gefunden {nodes}; weniger exportieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>a script</source>
            <translation>ein Skript</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>a server needs packages that cannot be loaded ({error}); install them with: {command}</source>
            <translation>ein Server braucht Pakete, die nicht geladen werden können ({error}); sie installieren mit: {command}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/skin.py" />
            <source>a skin names a bone that is not there; export it again</source>
            <translation>Ein Skin nennt einen Knochen, den es nicht gibt; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/skin.py" />
            <source>a skin of {n_joints} bones has {found} matrices for them; export it again</source>
            <translation>Ein Skin mit {n_joints} Knochen hat {found} Matrizen dafür; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/dsp/sonagram.py" />
            <source>a sonagram must rise within 0..{sample_rate} Hz, got {low} to {high}; choose other limits</source>
            <translation>Ein Sonagramm muss in 0..{sample_rate} Hz steigen, gefunden {low} bis {high}; andere Grenzen wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>A sound stood {db} dB above the background noise; keep quiet and measure it again.</source>
            <translation>Ein Geräusch lag {db} dB über dem Hintergrundgeräusch; nicht sprechen und noch einmal messen.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>a sparse accessor changes entry {where}, and it has {base}; export it again</source>
            <translation>Ein dünn besetzter Accessor ändert Eintrag {where}, er hat {base}; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>a sparse accessor changes {n} of {base} entries; it is damaged, export it again</source>
            <translation>Ein dünn besetzter Accessor ändert {n} von {base} Einträgen; beschädigt, neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/tone.py" />
            <source>a sweep must rise, got low {low} Hz and high {high} Hz; raise high or lower low</source>
            <translation>Ein Sweep muss steigen, gefunden {low} Hz bis {high} Hz; obere Frequenz erhöhen oder untere senken</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>a table</source>
            <translation>eine Tabelle</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/table_file.py" />
            <source>a table needs at least one recording, found none; name another folder</source>
            <translation>Eine Tabelle braucht mindestens eine Aufnahme, gefunden wurde keine; anderen Ordner angeben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/conversion/work.py" />
            <source>a table of frames has no place for words; leave the text out, or choose phonemes</source>
            <translation>Eine Tabelle von Frames hat keinen Platz für Wörter; Text weglassen oder Phoneme wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/feelings.py" />
            <source>a tag asks for the feeling {style}; {lexicon}</source>
            <translation>ein Tag verlangt das Gefühl {style}; {lexicon}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/takes/take.py" />
            <source>a take must be a table, found {entry}; correct it</source>
            <translation>Ein Take muss eine Tabelle sein, gefunden {entry}; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/takes/project.py" />
            <source>a take needs a sound and a speaker's name, got {samples} samples by {speaker}</source>
            <translation>Ein Take braucht Audio und einen Sprechernamen, gefunden {samples} Samples von {speaker}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/takes/take.py" />
            <source>a take's sound must lie in {takes}/ or {deleted}/ of its project, got {sound}; correct it</source>
            <translation>Die Audiodatei eines Takes muss in {takes}/ oder {deleted}/ seines Projekts liegen, gefunden {sound}; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/textgrid.py" />
            <source>a text in double quotes</source>
            <translation>ein Text in doppelten Anführungszeichen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/headers.py" />
            <source>a text in its LIST chunk claims more bytes than the list has</source>
            <translation>ein Text im LIST-Block gibt mehr Byte an, als die Liste hat</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/recording.py" />
            <source>a text is missing, found {value}</source>
            <translation>ein Text fehlt, gefunden {value}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>A to B</source>
            <translation>A nach B</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf.py" />
            <source>a triangle names vertex {corners}, and there are {n}; export it again</source>
            <translation>Ein Dreieck nennt Eckpunkt {corners}, es gibt {n}; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/features/variables.py" />
            <source>a variable named {name} exists already; choose another name</source>
            <translation>eine Variable namens {name} gibt es schon; einen anderen Namen wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/features/variables.py" />
            <source>a variable's name must be lower-case letters, digits and underscores, got {name}; rename it</source>
            <translation>Der Name einer Variable besteht aus Kleinbuchstaben, Ziffern und Unterstrichen, gefunden {name}; umbenennen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/skin.py" />
            <source>a vertex names bone {bones}, and its skin has {n_joints}; export it again</source>
            <translation>Ein Punkt nennt Knochen {bones}, der Skin hat {n_joints}; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/morph_mesh.py" />
            <source>a vertex that moves has no finite position; export it again</source>
            <translation>Ein bewegter Eckpunkt hat keine endliche Position; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>a view of {length} bytes begins at {begin}, and its buffer has {content}; export it again</source>
            <translation>Ein Ausschnitt von {length} Bytes beginnt bei {begin}, der Puffer hat {content}; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/visemes.py" />
            <source>a viseme set has 1..{most_visemes} different names, got {self}; correct it</source>
            <translation>Ein Visemsatz hat 1..{most_visemes} verschiedene Namen, gefunden {self}; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/exports/exporter.py" />
            <source>a whole number</source>
            <translation>eine ganze Zahl</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/textgrid.py" />
            <source>a whole number from 0</source>
            <translation>eine ganze Zahl ab 0</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/recording.py" />
            <source>a whole number is missing, found {value}</source>
            <translation>eine ganze Zahl fehlt, gefunden {value}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>a whole number within ±3.4e38</source>
            <translation>eine ganze Zahl in ±3.4e38</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/curves_file.py" />
            <source>a word begins before it ends, within {longest} s, found {start}..{end} s; export the curves again</source>
            <translation>Ein Wort muss vor seinem Ende und innerhalb von {longest} s beginnen, gefunden {start}..{end} s; Kurven neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>a-z, 0-9 and _, such as my_hiss</source>
            <translation>z. B. mein_zischen (a-z, 0-9, _)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>About PhonemeAnalyser</source>
            <translation>Über PhonemeAnalyser</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>Accuracy</source>
            <translation>Genauigkeit</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>accuracy not measured</source>
            <translation>Genauigkeit nicht gemessen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/exports.py" />
            <source>accuracy report by the labels beside the file</source>
            <translation>Genauigkeitsbericht nach den Beschriftungen neben der Datei</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>action units (FACS), as OpenFace has them</source>
            <translation>Action Units (FACS), wie OpenFace sie hat</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/feeling_lane.py" />
            <source>Activation</source>
            <translation>Aktivierung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/frame_views.py" />
            <source>Adapt the display gain to the loudness; moving the slider switches this off</source>
            <translation>Anzeigeverstärkung an die Lautstärke anpassen; Bewegen des Reglers schaltet das ab</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>Add</source>
            <translation>Hinzufügen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_editor.py" />
            <source>Add a condition to the current rule</source>
            <translation>Der aktuellen Regel eine Bedingung hinzufügen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>Add a condition with this variable to a rule</source>
            <translation>Einer Regel eine Bedingung mit dieser Variable hinzufügen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/variables_panel.py" />
            <source>Add a condition with this variable to a rule; the limit that gains most is proposed</source>
            <translation>Einer Regel eine Bedingung mit dieser Variable hinzufügen; vorgeschlagen wird die Grenze mit dem größten Gewinn</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/keys/key_lanes.py" />
            <source>add a key</source>
            <translation>Keyframe hinzufügen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/rules.py" />
            <source>add a rule</source>
            <translation>Regel hinzufügen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_editor.py" />
            <source>Add a rule in front of the current one. It is off until it has a condition.</source>
            <translation>Eine Regel vor der aktuellen hinzufügen. Sie ist aus, bis sie eine Bedingung hat.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>Add an averaged spectrum, measured through the filters that are on</source>
            <translation>Gemitteltes Spektrum hinzufügen, gemessen mit den eingeschalteten Filtern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Add Audio Files</source>
            <translation>Audiodateien hinzufügen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_editor.py" />
            <source>Add Condition…</source>
            <translation>Bedingung hinzufügen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Add Files…</source>
            <translation>Dateien hinzufügen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Add Folder</source>
            <translation>Ordner hinzufügen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Add Folder…</source>
            <translation>Ordner hinzufügen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/phoneme_data_model.py" />
            <source>add pitch set {name}</source>
            <translation>Grundfrequenz-Satz {name} hinzufügen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_editor.py" />
            <source>Add Rule</source>
            <translation>Regel hinzufügen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/phoneme_data_panel.py" />
            <source>Add Set…</source>
            <translation>Satz hinzufügen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/variables_panel.py" />
            <source>Add the suggested variable to the preset; Ctrl+Z removes it</source>
            <translation>Vorgeschlagene Variable zum Preset hinzufügen; Strg+Z entfernt sie</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>add variable {name}</source>
            <translation>Variable {name} anlegen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>add {take}</source>
            <translation>Hinzufügen von {take}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>add-on for Godot 4 (GDScript and C#), with the same two</source>
            <translation>Add-on für Godot 4 (GDScript und C#), mit denselben beiden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Added to the log-odds of {phoneme}: each +1 makes it 2.7 times more likely. The bar shows by how much it trails the most likely other phoneme; it is recognised while the bar is left of the handle.</source>
            <translation>Wird zur logarithmierten Chance von {phoneme} addiert: Jede +1 macht es 2.7-mal wahrscheinlicher. Der Balken zeigt, um wie viel es hinter dem wahrscheinlichsten anderen Phonem liegt; es wird erkannt, solange der Balken links vom Griff endet.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/phoneme_data_model.py" />
            <source>Added {name}, for a pitch of {low:.0f}–{high:.0f} Hz</source>
            <translation>{name} hinzugefügt, für Grundfrequenzen von {low:.0f}–{high:.0f} Hz</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/serve_dialog.py" />
            <source>Address</source>
            <translation>Adresse</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Address (HOST:PORT) at which messages of other programs are received, such as 127.0.0.1:39540</source>
            <translation>Adresse (HOST:PORT), an der Nachrichten anderer Programme empfangen werden, zum Beispiel 127.0.0.1:39540</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Address (HOST:PORT) of the program that receives the messages, such as 127.0.0.1:39539</source>
            <translation>Adresse (HOST:PORT) des Programms, das die Nachrichten empfängt, zum Beispiel 127.0.0.1:39539</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>Address already in use</source>
            <translation>Adresse wird schon benutzt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Address for receiving expressions</source>
            <translation>Adresse zum Empfang von Ausdrücken</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>Add…</source>
            <translation>Neu…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>affect the variables</source>
            <translation>wirken auf die Variablen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_layout.py" />
            <source>affricate</source>
            <translation>Affrikate</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>After</source>
            <translation>Nachher</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>After all filters</source>
            <translation>Nach allen Filtern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/sonagram.py" />
            <source>After Filters</source>
            <translation>Nach Filtern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>After smoothing, high-pass and low-pass</source>
            <translation>Nach Glättung, Hoch- und Tiefpass</translation>
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
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Align Even If the Text Seems Different</source>
            <translation>Trotz abweichenden Textes ausrichten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Align finds each word in the recording. Without a recording, a voice says the text.</source>
            <translation>Ausrichten findet jedes Wort in der Aufnahme. Ohne Aufnahme spricht eine Stimme den Text.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Align Text with Recording</source>
            <translation>Text an Aufnahme ausrichten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Align the text, though it doesn’t seem to match the recording</source>
            <translation>Den Text ausrichten, obwohl er nicht zur Aufnahme zu passen scheint</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Aligned words ({n})</source>
            <translation>Ausgerichtete Wörter ({n})</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>alignment</source>
            <translation>Ausrichten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/sound_words.py" />
            <source>alignment of a word</source>
            <translation>Ausrichten eines Wortes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>All</source>
            <translation>Alle</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/phoneme_data_panel.py" />
            <source>all</source>
            <translation>alle</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>All labels are ambiguous, so there are no distributions; load others</source>
            <translation>Alle Beschriftungen sind mehrdeutig, daher gibt es keine Verteilungen; andere laden</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf.py" />
            <source>all morph targets have at most {most_offsets} vertices together; make it coarser</source>
            <translation>Alle Morph-Targets zusammen haben höchstens {most_offsets} Eckpunkte; gröber machen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/variables_panel.py" />
            <source>all others</source>
            <translation>alle anderen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_editor.py" />
            <source>All phonemes</source>
            <translation>Alle Phoneme</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>all variables every 10 ms, CSV</source>
            <translation>alle Variablen alle 10 ms, CSV</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>all variables every 10 ms, JSON</source>
            <translation>alle Variablen alle 10 ms, JSON</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/exports.py" />
            <source>already done</source>
            <translation>schon fertig</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_tree.py" />
            <source>always</source>
            <translation>immer</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_tree.py" />
            <source>always holds here</source>
            <translation>gilt hier immer</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>always holds in the loaded sound: no later rule is reached</source>
            <translation>gilt im geladenen Ton immer: keine spätere Regel wird erreicht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_layout.py" />
            <source>ambiguous</source>
            <translation>mehrdeutig</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Amharic</source>
            <translation>Amharisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/frame_views.py" />
            <source>Amplitude</source>
            <translation>Amplitude</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>amplitude</source>
            <translation>Amplitude</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>an accessor has at most {most_entries} entries, got {n}; make the mesh coarser</source>
            <translation>Ein Accessor hat höchstens {most_entries} Einträge, gefunden {n}; Mesh gröber machen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>an accessor is of type {kind} {shape}, which no vertex has; export it again</source>
            <translation>Ein Accessor ist vom Typ {kind} {shape}, den kein Eckpunkt hat; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>an accessor needs {needed} bytes at {begin}, and its buffer has {content}; it is damaged, export it again</source>
            <translation>Ein Accessor braucht {needed} Byte ab {begin}, sein Puffer hat {content}; beschädigt, neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/analyser.py" />
            <source>an analysis buffer has the shape ({window},), got {shape}; give one of mono</source>
            <translation>Ein Analysepuffer hat die Form ({window},), gefunden {shape}; einen in Mono übergeben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/vrm.py" />
            <source>an avatar has at most {most_expressions} expressions; leave some out</source>
            <translation>Ein Avatar hat höchstens {most_expressions} Ausdrücke; einige weglassen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/key_layer.py" />
            <source>an edited blend shape has 2..{most_keys} keys, got {self}; correct them</source>
            <translation>Ein bearbeiteter Blendshape hat 2..{most_keys} Keyframes, gefunden {self}; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/cleaning.py" />
            <source>an empty text</source>
            <translation>ein leerer Text</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/storage/strict_table.py" />
            <source>an endless number</source>
            <translation>eine endlose Zahl</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/expression/streams.py" />
            <source>an expression is shown by 0..1, found {share} for {name}; correct it</source>
            <translation>Ein Ausdruck wird mit 0..1 gezeigt, gefunden {share} für {name}; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/expression/composer.py" />
            <source>an expression needs a stream; name a preset such as smile</source>
            <translation>Ein Ausdruck braucht einen Kanal; einen vorgegebenen wie smile angeben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/key_layer.py" />
            <source>an offset lies in -1..1, found {offsets}; correct it</source>
            <translation>Ein Versatz liegt in -1..1, gefunden {offsets}; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/osc.py" />
            <source>an OSC receiver is HOST:PORT, such as 127.0.0.1:39539, found {text}; correct it</source>
            <translation>Ein OSC-Empfänger ist HOST:PORT, etwa 127.0.0.1:39539, gefunden {text}; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/headers.py" />
            <source>an unnamed chunk</source>
            <translation>ein Block ohne Namen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Analyse</source>
            <translation>Analysieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/score_strip.py" />
            <source>analysing…</source>
            <translation>wird analysiert …</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>analysis</source>
            <translation>Analyse</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>anger</source>
            <translation>Ärger</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/welcome.py" />
            <source>Animate a Recording</source>
            <translation>Aufnahme animieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/exports.py" />
            <source>animated GIF of the head</source>
            <translation>animiertes GIF des Kopfes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Annosoft phonemes</source>
            <translation>Annosoft-Phoneme</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>another program uses it</source>
            <translation>ein anderes Programm benutzt den Port</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/table_file.py" />
            <source>another program wrote it</source>
            <translation>ein anderes Programm hat sie geschrieben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>anti-aliased</source>
            <translation>ohne Aliasing</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Any language</source>
            <translation>Beliebige Sprache</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Apply</source>
            <translation>Übernehmen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Apply the fitted thresholds; Ctrl+Z restores the old ones</source>
            <translation>Angepasste Schwellen übernehmen; Strg+Z stellt die alten wieder her</translation>
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
            <location filename="../../../engine/phonemeengine/mouth/expression/streams.py" />
            <source>ARKit has no blend shape {name}; name one such as mouthSmile or mouthSmileLeft</source>
            <translation>ARKit hat keinen Blendshape {name}; einen angeben wie mouthSmile oder mouthSmileLeft</translation>
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
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Arrows</source>
            <translation>Pfeiltasten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Assamese</source>
            <translation>Assamesisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/page.py" />
            <source>Assign</source>
            <translation>Zuordnen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Asymmetry</source>
            <translation>Asymmetrie</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Attack</source>
            <translation>Attack</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Attack and release of each phoneme</source>
            <translation>Attack und Release jedes Phonems</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Attack time</source>
            <translation>Attack-Zeit</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Attack: time in which the mouth covers 90 % of the way to the shape of a phoneme. Release: time in which it covers 90 % of the way back when silence follows. To change them, copy a mouth table from {tables}, edit its section [times], and load it.</source>
            <translation>Attack: Zeit, in der der Mund 90 % des Weges zur Form eines Phonems zurücklegt. Release: Zeit, in der er 90 % des Rückwegs zurücklegt, wenn Stille folgt. Zum Ändern eine Mundtabelle aus {tables} kopieren, ihren Abschnitt [times] bearbeiten und sie laden.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Audacity label track</source>
            <translation>Textspur für Audacity</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Audacity labels</source>
            <translation>Textmarken von Audacity</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Audacity labels (*.txt)</source>
            <translation>Audacity-Textmarken (*.txt)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/file_asker.py" />
            <source>Audio and video files ({patterns});;All files (*)</source>
            <translation>Audio- und Videodateien ({patterns});;Alle Dateien (*)</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/stream.py" />
            <source>audio cannot be played or recorded, since PortAudio is missing or broken; install libportaudio2</source>
            <translation>Audio kann weder abgespielt noch aufgenommen werden, da PortAudio fehlt oder defekt ist; libportaudio2 installieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/stream.py" />
            <source>audio cannot be played or recorded, since the package sounddevice is missing; install it with pip install sounddevice</source>
            <translation>Audio kann weder abgespielt noch aufgenommen werden, da das Paket sounddevice fehlt; installieren mit pip install sounddevice</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Audio file</source>
            <translation>Audiodatei</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Audio files to export</source>
            <translation>Zu exportierende Audiodateien</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Audio Files with Label Files…</source>
            <translation>Audiodateien mit Beschriftungsdateien…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/frame_views.py" />
            <source>Auto</source>
            <translation>Auto</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Automatic</source>
            <translation>Automatisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>Average by Phoneme</source>
            <translation>Nach Phonem mitteln</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Average Spectrum</source>
            <translation>Spektrum mitteln</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>Averaged spectra</source>
            <translation>Gemittelte Spektren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>Averaged spectrum</source>
            <translation>Gemitteltes Spektrum</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Averages each bin with its neighbours; 1 is the mean of three bins.</source>
            <translation>Mittelt jede Frequenzstufe mit ihren Nachbarn; 1 ist das Mittel aus dreien.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Averages each spectrum with the previous one; closer to 1 is slower.</source>
            <translation>Mittelt jedes Spektrum mit dem vorigen; näher an 1 ist langsamer.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Azerbaijani</source>
            <translation>Aserbaidschanisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/tour.py" />
            <source>Back</source>
            <translation>Zurück</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Back 1 s</source>
            <translation>1 s zurück</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Back 10 ms</source>
            <translation>10 ms zurück</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Background</source>
            <translation>Hintergrund</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>background noise</source>
            <translation>Hintergrundgeräusch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/model.py" />
            <source>background noise measurement</source>
            <translation>Messung des Hintergrundgeräuschs</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/takes/room_noise.py" />
            <source>background noise must be measured for {least_seconds} s or more, got {seconds} s; keep quiet for two seconds</source>
            <translation>Das Hintergrundgeräusch muss mindestens {least_seconds} s lang gemessen werden, gefunden {seconds} s; zwei Sekunden still sein</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Background noise not measured yet</source>
            <translation>Hintergrundgeräusch noch nicht gemessen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Background noise recognised as silence: {noise}</source>
            <translation>Hintergrundgeräusch als Stille erkannt: {noise}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Background noise recognised as silence: {noise}; speech in the takes: {speech}</source>
            <translation>Hintergrundgeräusch als Stille erkannt: {noise}; Sprache in den Takes: {speech}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Background noise {decibels:.0f} dBFS</source>
            <translation>Hintergrundgeräusch {decibels:.0f} dBFS</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/model.py" />
            <source>Background noise {decibels:.0f} dBFS, measured for {seconds:.1f} s. {accuracy}. Ctrl+Z undoes this.</source>
            <translation>Hintergrundgeräusch {decibels:.0f} dBFS, {seconds:.1f} s lang gemessen. {accuracy}. Strg+Z macht es rückgängig.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
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
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/figures_table.py" />
            <source>Becomes</source>
            <translation>Wird zu</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Before</source>
            <translation>Vorher</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>Before all spectral filters</source>
            <translation>Vor allen Filtern des Spektrums</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_editor.py" />
            <source>Begin with Extended Rules</source>
            <translation>Mit Extended rules beginnen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/recognition/spec.py" />
            <source>begin with the preset {factory_preset}</source>
            <translation>mit dem Preset {factory_preset} beginnen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Belarusian</source>
            <translation>Belarussisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>below the first limit; M if no other</source>
            <translation>unter der ersten Grenze; M, wenn sonst keines</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Bengali</source>
            <translation>Bengalisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Beside each audio file</source>
            <translation>Neben jede Audiodatei</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Best fit and joins (Viterbi)</source>
            <translation>Beste Passung (Viterbi)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Best rate</source>
            <translation>Beste Rate</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/distribution.py" />
            <source>best threshold {value}</source>
            <translation>beste Schwelle {value}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Blend of styles</source>
            <translation>Mischung der Stile</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Blend shape</source>
            <translation>Blendshape</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/mapping_dialog.py" />
            <source>Blend shape of this face for {name}</source>
            <translation>Blendshape dieses Gesichts für {name}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/mapping_dialog.py" />
            <source>Blend shapes</source>
            <translation>Blendshapes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Blend shapes on which the pose decides, with their weights in percent</source>
            <translation>Blendshapes, die die Pose bestimmt, mit ihren Gewichten in Prozent</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Blend shapes to send</source>
            <translation>Gesendete Blendshapes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/keys/key_panel.py" />
            <source>Blend shapes ▾</source>
            <translation>Blendshapes ▾</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/mapping_dialog.py" />
            <source>Blend shapes, and those of this face</source>
            <translation>Blendshapes und die dieses Gesichts</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Blink at natural intervals</source>
            <translation>In natürlichen Abständen blinzeln</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Blinks</source>
            <translation>Blinzeln</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Boosts high frequencies: subtracts a share of the previous sample from each sample.</source>
            <translation>Hebt hohe Frequenzen an: Von jedem Abtastwert wird ein Anteil des vorigen abgezogen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Bosnian</source>
            <translation>Bosnisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Both have the same macro F1.</source>
            <translation>Beide haben dasselbe Makro-F1.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/difference_model.py" />
            <source>Both heads move alike</source>
            <translation>Beide Köpfe bewegen sich gleich</translation>
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
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Brows follow the voice</source>
            <translation>Brauen folgen der Stimme</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Bulgarian</source>
            <translation>Bulgarisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Bust</source>
            <translation>Büste</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>By how much another phoneme must score higher to replace the current one (hysteresis).</source>
            <translation>Um wie viel ein anderes Phonem besser bewertet sein muss, um das aktuelle abzulösen (Hysterese).</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>By how much another phoneme must score higher to replace the current one. The bar shows by how much it does now.</source>
            <translation>Um wie viel ein anderes Phonem besser bewertet sein muss, um das aktuelle zu ersetzen. Der Balken zeigt, um wie viel es das jetzt ist.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>By Phoneme…</source>
            <translation>Nach Phonem…</translation>
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
            <source>C99 source for any program</source>
            <translation>C99-Quelltext für beliebige Programme</translation>
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
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Calibrate page</source>
            <translation>Seite Kalibrieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Calibrate to your voice step by step, in under a minute (G)</source>
            <translation>Schritt für Schritt auf die eigene Stimme kalibrieren, in weniger als einer Minute (G)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Calibrate with nine single sounds instead of a sentence</source>
            <translation>Mit neun einzelnen Lauten statt mit einem Satz kalibrieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>Calibrate: 1 recording</source>
            <translation>Kalibrieren: 1 Aufnahme</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>Calibrate: {n} recordings</source>
            <translation>Kalibrieren: {n} Aufnahmen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Calibrating</source>
            <translation>Kalibrierung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Calibrating to your voice</source>
            <translation>Kalibrierung auf die Stimme</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>calibration</source>
            <translation>Kalibrierung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_tree.py" />
            <source>can never hold</source>
            <translation>kann nie gelten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>can never hold: two conditions contradict each other</source>
            <translation>kann nie gelten: zwei Bedingungen widersprechen sich</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Cancel</source>
            <translation>Abbrechen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Cancel the calibration and delete its takes; Ctrl+Z restores them (Escape)</source>
            <translation>Kalibrierung abbrechen und ihre Takes löschen; Strg+Z stellt sie wieder her (Esc)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/exports.py" />
            <source>cancelled</source>
            <translation>abgebrochen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>Cannot overwrite a value</source>
            <translation>Doppelter Wert</translation>
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
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Change</source>
            <translation>Wechsel</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/rules.py" />
            <source>change a condition</source>
            <translation>Bedingung ändern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/rules.py" />
            <source>change a rule</source>
            <translation>Regel ändern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>change file model</source>
            <translation>Modell für Dateien ändern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/felt_text.py" />
            <source>change of a feeling</source>
            <translation>Ändern eines Gefühls</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/curves.py" />
            <source>change of the filters</source>
            <translation>Änderung der Filter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_model.py" />
            <source>change of the style {name}</source>
            <translation>Änderung des Stils {name}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/phoneme_data_model.py" />
            <source>change pitch range</source>
            <translation>Grundfrequenzbereich ändern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>change real-time model</source>
            <translation>Echtzeitmodell ändern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>change the permissions or record to another folder</source>
            <translation>Berechtigungen ändern oder in einen anderen Ordner aufnehmen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/phoneme_data_model.py" />
            <source>change {what}</source>
            <translation>{what} ändern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Changed</source>
            <translation>Geändert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>changed</source>
            <translation>geändert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>changed on disk</source>
            <translation>Datei geändert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/phoneme_view.py" />
            <source>Changes often: {variable} crossed {limit} in {n} of {all} changes seen</source>
            <translation>Wechselt oft: {variable} kreuzte {limit} in {n} von {all} gesehenen Wechseln</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>Changes/s</source>
            <translation>Wechsel/s</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Channel</source>
            <translation>Kanal</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Channel of the file</source>
            <translation>Kanal der Datei</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Channel of the file that is analysed</source>
            <translation>Kanal der Datei, der analysiert wird</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Channel of the microphone</source>
            <translation>Kanal des Mikrofons</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Channel that is analysed and recorded; 1 + 2: mixed for analysis, recorded in stereo</source>
            <translation>Kanal, der analysiert und aufgenommen wird; 1 + 2: für die Analyse gemischt, in Stereo aufgenommen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Channel {k}</source>
            <translation>Kanal {k}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/take_list.py" />
            <source>Check</source>
            <translation>Prüfung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>check it or record to another disk</source>
            <translation>prüfen oder auf ein anderes Laufwerk aufnehmen</translation>
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
            <location filename="../../../engine/phonemeengine/speech/silent.py" />
            <source>Chinese syllable</source>
            <translation>chinesische Silbe</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/mandarin.py" />
            <source>Chinese text needs the package pypinyin, which is missing; pip install 'pypinyin'</source>
            <translation>für chinesischen Text fehlt das Paket pypinyin; installieren mit pip install 'pypinyin'</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Choose a face, or load one of your own.</source>
            <translation>Ein Gesicht wählen oder ein eigenes laden.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/ship_dialog.py" />
            <source>Choose a separate folder</source>
            <translation>Eigenen Ordner wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>Choose all phonemes but silence</source>
            <translation>Alle Phoneme außer Stille wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>Choose all speakers</source>
            <translation>Alle Sprecher wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/recognition/spec.py" />
            <source>choose another preset</source>
            <translation>anderes Preset wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>Choose at least one speaker and one phoneme that the labels have.</source>
            <translation>Mindestens einen Sprecher und ein Phonem wählen, das in den Beschriftungen vorkommt.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/ship_dialog.py" />
            <source>Choose Folder</source>
            <translation>Ordner wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/preset_choice.py" />
            <source>Choose Folder…</source>
            <translation>Ordner wählen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Choose language…</source>
            <translation>Sprache wählen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>Choose no speaker</source>
            <translation>Keinen Sprecher wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/timed_words.py" />
            <source>choose one as the speaker</source>
            <translation>einen als Sprecher wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>choose one of {names}</source>
            <translation>eins wählen aus {names}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>choose one of {names}, or a shape such as mouthSmile</source>
            <translation>eins wählen aus {names} oder eine Mundform wie mouthSmile</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/page.py" />
            <source>Choose PhonemeData for a Pitch Set</source>
            <translation>PhonemeData für einen Grundfrequenz-Satz wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Choose Preset B…</source>
            <translation>Preset B wählen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Choose Preset to Compare…</source>
            <translation>Preset zum Vergleich wählen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Choose speaker…</source>
            <translation>Sprecher wählen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/page.py" />
            <source>Choose Takes Folder</source>
            <translation>Takes-Ordner wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/keys/key_panel.py" />
            <source>Choose the blend shapes whose curves are shown</source>
            <translation>Blendshapes wählen, deren Kurven zu sehen sind</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/preset_choice.py" />
            <source>Choose the Folder with model.bin of Whisper base</source>
            <translation>Ordner mit model.bin von Whisper base wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Choose the takes folder, write label files, or remove deleted takes</source>
            <translation>Takes-Ordner wählen, Beschriftungsdateien schreiben oder gelöschte Takes entfernen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Choose the voice, its speech rate, and what moves the mouth (now: {who}; {moved})</source>
            <translation>Stimme, Sprechtempo und Steuerung des Mundes wählen (jetzt: {who}; {moved})</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>Choose the vowels</source>
            <translation>Die Vokale wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/ship_dialog.py" />
            <source>Choose…</source>
            <translation>Wählen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>chosen</source>
            <translation>gewählt</translation>
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
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Clear B</source>
            <translation>B entfernen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/preset_choice.py" />
            <source>Clear Folder</source>
            <translation>Ordner entfernen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>Click a cell of the matrix to list its segments.</source>
            <translation>Klick auf eine Zelle der Matrix listet ihre Segmente auf.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/figures_table.py" />
            <source>Click a segment to play it, or select one and press Return</source>
            <translation>Klick spielt ein Segment ab; oder eines auswählen und die Eingabetaste drücken</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/confusion_view.py" />
            <source>Click a segment to play it; scroll the wheel to zoom, drag to pan</source>
            <translation>Klick spielt ein Segment ab; Mausrad zoomt, Ziehen verschiebt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Click a word to play it, and drag boundaries that are wrong. Words that fit badly are hatched and listed.</source>
            <translation>Ein Klick spielt ein Wort ab; falsche Grenzen lassen sich ziehen. Wörter, die schlecht passen, sind schraffiert und aufgelistet.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/time_line.py" />
            <source>Click a word to play it, double-click to rename it, drag a boundary to move it. Left, Right: one picture. Up, Down or the wheel: zoom. Drag: scroll. F2: rename, to a word or to IPA between slashes. Insert: another word. Enter: split. Delete: delete.</source>
            <translation>Wort anklicken: abspielen; Doppelklick: umbenennen. Grenze ziehen: verschieben. Links, Rechts: ein Bild. Auf, Ab oder Mausrad: zoomen. Ziehen: scrollen. F2: umbenennen, in ein Wort oder IPA zwischen Schrägstrichen. Einfg: weiteres Wort. Eingabetaste: teilen. Entf: löschen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/time_line.py" />
            <source>Click a word to play it. Left, Right: one picture. Up, Down or the wheel: zoom. Drag: scroll. The voice sets the boundaries: to move them, save the spoken text and open that file.</source>
            <translation>Wort anklicken: abspielen. Links, Rechts: ein Bild. Auf, Ab oder Mausrad: zoomen. Ziehen: scrollen. Die Stimme legt die Grenzen fest: zum Verschieben den gesprochenen Text speichern und diese Datei öffnen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/spoken_lanes.py" />
            <source>Click to play the original with its face, double-click for the whole recording.</source>
            <translation>Klick spielt das Original mit seinem Gesicht, Doppelklick die ganze Aufnahme.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>Click: make it the value of a threshold of this variable</source>
            <translation>Klick: eine Schwelle dieser Variable auf diesen Wert setzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/distribution.py" />
            <source>Click: make it the value of {threshold}</source>
            <translation>Klick: {threshold} auf diesen Wert setzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/serve_dialog.py" />
            <source>Clients need a token</source>
            <translation>Clients brauchen ein Token</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>clip</source>
            <translation>Clip</translation>
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
            <location filename="../../../phonemeanalyser/desktop/session/exports.py" />
            <source>Clips have no preview. The Talk page shows the same head.</source>
            <translation>Für Clips gibt es keine Vorschau. Die Seite Sprechen zeigt denselben Kopf.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Close</source>
            <translation>Schließen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/welcome.py" />
            <source>Close cards</source>
            <translation>Karten schließen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/welcome.py" />
            <source>Close the cards; Help shows them again</source>
            <translation>Karten schließen; unter Hilfe sind sie wieder zu finden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/frame_views.py" />
            <source>Coarse</source>
            <translation>Grob</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Coarse Display</source>
            <translation>Grobe Darstellung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/frame_views.py" />
            <source>Coarse display: minimum and maximum of each eight adjacent samples</source>
            <translation>Grobe Darstellung: Minimum und Maximum von je acht benachbarten Abtastwerten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/frame_views.py" />
            <source>Coarse display: the maximum of each eight adjacent bins as one step</source>
            <translation>Grobe Darstellung: das Maximum von je acht benachbarten Frequenzstufen als eine</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>Colour</source>
            <translation>Farbe</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/sonagram.py" />
            <source>Colour map</source>
            <translation>Farbschema</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/sonagram.py" />
            <source>Colours from</source>
            <translation>Farben von</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/sonagram.py" />
            <source>Colours of the levels in the sonagram</source>
            <translation>Farben der Pegel im Sonagramm</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>Colour…</source>
            <translation>Farbe…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
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
            <source>Command of the external program, such as: {example}</source>
            <translation>Befehl des externen Programms, zum Beispiel: {example}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>Compare</source>
            <translation>Vergleich</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/preset_choice.py" />
            <source>Compare the marked preset with the one in use (Ctrl+Return)</source>
            <translation>Das markierte Preset mit dem verwendeten vergleichen (Strg+Eingabetaste)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Compare with the recognised phonemes:</source>
            <translation>Mit den erkannten Phonemen vergleichen:</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Compare ▾</source>
            <translation>Vergleichen ▾</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/phoneme_data_panel.py" />
            <source>Compared</source>
            <translation>Verglichen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/difference_model.py" />
            <source>Comparing…</source>
            <translation>Wird verglichen …</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Comparison tabs</source>
            <translation>Reiter des Vergleichs</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Component</source>
            <translation>Bestandteil</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/face_learning.py" />
            <source>components are of blend shapes, and no channel of the recordings is one; name others</source>
            <translation>Komponenten sind die von Blendshapes, und kein Kanal der Aufnahmen ist einer; andere nennen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/face_learning.py" />
            <source>components explain a share in 0..1 of what moves, got {share}; choose another</source>
            <translation>Komponenten erklären einen Anteil von 0..1 der Bewegung, gegeben ist {share}; einen anderen wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/rule_dialogs.py" />
            <source>Condition</source>
            <translation>Bedingung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_editor.py" />
            <source>Condition…</source>
            <translation>Bedingung…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/phoneme_view.py" />
            <source>Confidence {percent:.0f} %</source>
            <translation>Konfidenz {percent:.0f} %</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/confusion_view.py" />
            <source>Confusion matrix</source>
            <translation>Konfusionsmatrix</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/recognition/decoder.py" />
            <source>confusions lacks silence, with which every sound begins; add it</source>
            <translation>confusions fehlt silence, womit jede Aufnahme beginnt; ergänzen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/recognition/decoder.py" />
            <source>confusions of {label} are {phoneme} numbers in {least_evidence}..0 nats, one for each answer; found {row}</source>
            <translation>confusions von {label} sind {phoneme} Zahlen in {least_evidence}..0 Nat, eine für jede Antwort; gefunden: {row}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>Connection refused</source>
            <translation>Verbindung abgelehnt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>consonant-triphone</source>
            <translation>Konsonanten-Triphon</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Copied {n} frames as a table; paste them into a spreadsheet.</source>
            <translation>{n} Frames als Tabelle kopiert; in eine Tabellenkalkulation einfügen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Copy</source>
            <translation>Kopieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Copy Frames as Table</source>
            <translation>Frames als Tabelle kopieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Copy Picture</source>
            <translation>Bild kopieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/label_tiers.py" />
            <source>Copy saved as {path}, without {lost}: the format can't store that. A TextGrid keeps all.</source>
            <translation>Kopie gespeichert als {path}, ohne {lost}: Das Format kann das nicht speichern. Ein TextGrid behält alles.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/plot.py" />
            <source>Copy Table</source>
            <translation>Tabelle kopieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Copy the table as tab-separated text</source>
            <translation>Tabelle als tabulatorgetrennten Text kopieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/plot.py" />
            <source>Copy Values</source>
            <translation>Werte kopieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Corpus labels (*.csv)</source>
            <translation>Korpus-Beschriftungen (*.csv)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Corpus table: class, phone, certainty</source>
            <translation>Korpustabelle: Klasse, Phon, Gewissheit</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Cost of a change</source>
            <translation>Kosten eines Wechsels</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Cost of each change of phoneme in the decoder; a higher cost gives fewer changes.</source>
            <translation>Kosten jedes Phonemwechsels im Decoder; höhere Kosten ergeben weniger Wechsel.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Created with the first take</source>
            <translation>Entsteht mit dem ersten Take</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Croatian</source>
            <translation>Kroatisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Current phoneme</source>
            <translation>Aktuelles Phonem</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Current phoneme; the line below it is its intensity</source>
            <translation>Aktuelles Phonem; die Linie darunter ist seine Intensität</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/movestate_bars.py" />
            <source>Current weight of each blend shape of the face, in percent; of two sides in one row, the upper bar is the left one</source>
            <translation>Aktuelles Gewicht jedes Blendshapes des Gesichts in Prozent; bei zwei Seiten in einer Zeile ist der obere Balken der linke</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/frame_views.py" />
            <source>Current window of 46.4 ms, after the time-domain filters; full scale is ±1</source>
            <translation>Aktuelles Fenster von 46.4 ms, nach den Filtern im Zeitbereich; Vollaussteuerung ist ±1</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>Curves</source>
            <translation>Kurven</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>Curves (*.csv)</source>
            <translation>Kurven (*.csv)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/sonagram.py" />
            <source>Curves drawn over the sonagram, and lanes below it: formants, pitch, level, feeling, words</source>
            <translation>Kurven über dem Sonagramm und Spuren darunter: Formanten, Tonhöhe, Pegel, Gefühl, Wörter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>curves for Unity, Godot and web pages</source>
            <translation>Kurven für Unity, Godot und Webseiten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>custom</source>
            <translation>eigener</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Custom variable</source>
            <translation>Eigene Variable</translation>
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
            <source>Dark</source>
            <translation>Dunkel</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>database disk image is malformed</source>
            <translation>Datenbank ist beschädigt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>decides no frame of the loaded sound: earlier rules do</source>
            <translation>entscheidet keinen Frame des geladenen Tons: frühere Regeln tun es</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Decimation</source>
            <translation>Dezimierung</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Decoder</source>
            <translation>Decoder</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Default microphone</source>
            <translation>Standardmikrofon</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Default voice of the language</source>
            <translation>Standardstimme der Sprache</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>deficit of {phoneme}</source>
            <translation>Rückstand von {phoneme}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Del</source>
            <translation>Entf</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_editor.py" />
            <source>Delete</source>
            <translation>Löschen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Delete</source>
            <comment>verb</comment>
            <translation>Löschen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/rules.py" />
            <source>delete a condition</source>
            <translation>Bedingung löschen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/keys/key_lanes.py" />
            <source>delete a key</source>
            <translation>Keyframe löschen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/rules.py" />
            <source>delete a rule</source>
            <translation>Regel löschen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/keys/key_panel.py" />
            <source>Delete All</source>
            <translation>Alle löschen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/keys/key_model.py" />
            <source>delete all keys</source>
            <translation>alle Keyframes löschen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/keys/key_panel.py" />
            <source>Delete all keys; Ctrl+Z restores them</source>
            <translation>Alle Keyframes löschen; Strg+Z stellt sie wieder her</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/keys/key_lanes.py" />
            <source>Delete Key</source>
            <translation>Keyframe löschen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Delete key</source>
            <translation>Keyframe löschen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Delete Label</source>
            <translation>Beschriftung löschen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/label_tiers.py" />
            <source>delete label</source>
            <translation>Beschriftung löschen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Delete take</source>
            <translation>Take löschen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_editor.py" />
            <source>Delete the current rule or condition (Delete)</source>
            <translation>Aktuelle Regel oder Bedingung löschen (Entf)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Delete the selected takes (Delete); Ctrl+Z restores them</source>
            <translation>Ausgewählte Takes löschen (Entf); Strg+Z stellt sie wieder her</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Delete Word or Phone (Del)</source>
            <translation>Wort oder Phon löschen (Entf)</translation>
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
            <location filename="../../../phonemeanalyser/desktop/talk/words/sound_words.py" />
            <source>deletion of a phone</source>
            <translation>Löschen eines Phons</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/sound_words.py" />
            <source>deletion of a word</source>
            <translation>Löschen eines Wortes</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Denoise</source>
            <translation>Entrauschen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Detail</source>
            <translation>Detail</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>did you mean {first} or {second}?</source>
            <translation>ist {first} oder {second} gemeint?</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>did you mean {first}, {second} or {third}?</source>
            <translation>ist {first}, {second} oder {third} gemeint?</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>did you mean {name}?</source>
            <translation>ist {name} gemeint?</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Difference</source>
            <translation>Unterschied</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/difference_model.py" />
            <source>Difference (RMS): {rms:.3f} · greatest: {shape} {greatest:.2f}</source>
            <translation>Unterschied (RMS): {rms:.3f} · größter: {shape} {greatest:.2f}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Difference in matrix</source>
            <translation>Unterschied in der Matrix</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/comparison.py" />
            <source>Difference of the weights of all blend shapes, 0 to 1: the root mean square, and the greatest one</source>
            <translation>Unterschied der Gewichte aller Blendshapes, 0 bis 1: quadratisches Mittel und größter Wert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/score_strip.py" />
            <source>Difference since this change began: it was {before}.</source>
            <translation>Differenz seit Beginn dieser Änderung; vorher {before}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>Differences of the averaged spectra</source>
            <translation>Unterschiede der gemittelten Spektren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>diphone</source>
            <translation>Diphon</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_layout.py" />
            <source>diphthong</source>
            <translation>Diphthong</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Discard</source>
            <translation>Verwerfen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/preset_dialogs.py" />
            <source>Discard Changes</source>
            <translation>Änderungen verwerfen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Discard the marked range</source>
            <translation>Markierten Bereich verwerfen</translation>
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
            <location filename="../../../phonemeanalyser/desktop/widgets/banner.py" />
            <source>Dismiss message</source>
            <translation>Meldung schließen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>display</source>
            <translation>Anzeige</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/frame_views.py" />
            <source>Display gain, 0 to 40 dB: enlarges quiet signals</source>
            <translation>Anzeigeverstärkung, 0 bis 40 dB: vergrößert leise Signale</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/frame_views.py" />
            <source>Display gain, 0 to 60 dB: enlarges small amplitudes</source>
            <translation>Anzeigeverstärkung, 0 bis 60 dB: vergrößert kleine Amplituden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/distribution.py" />
            <source>Distribution of the variable</source>
            <translation>Verteilung der Variable</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Divides each spectrum by its largest amplitude, which makes it independent of loudness.</source>
            <translation>Teilt jedes Spektrum durch seine größte Amplitude; so wird es unabhängig von der Lautstärke.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Done</source>
            <translation>Fertig</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/exports.py" />
            <source>done</source>
            <translation>fertig</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/preset_choice.py" />
            <source>Download (145 MB)</source>
            <translation>Herunterladen (145 MB)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/preset_choice.py" />
            <source>Downloading the model (145 MB)…</source>
            <translation>Modell wird heruntergeladen (145 MB)…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/keys/key_lanes.py" />
            <source>Drag a key, or move the selected one with the arrow keys (Shift: farther). Double-click adds a key, Delete removes it. Shift+drag, or Shift+Left and Shift+Right, marks a range to smooth, raise or lower. Page Up, Page Down: select another key; with Ctrl, another curve.</source>
            <translation>Einen Keyframe ziehen oder den ausgewählten mit den Pfeiltasten verschieben (Umschalt: weiter). Doppelklick fügt einen hinzu, Entf entfernt ihn. Umschalt+Ziehen oder Umschalt+Links und Umschalt+Rechts markieren einen Bereich zum Glätten, Anheben oder Absenken. Bild auf, Bild ab: anderer Keyframe; mit Strg: andere Kurve.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Drag the edges to trim the take; the arrow keys move the start by 10 ms, with Shift the end</source>
            <translation>Kanten ziehen, um den Take zuzuschneiden; Pfeiltasten verschieben den Anfang um 10 ms, mit Umschalt das Ende</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/head_view.py" />
            <source>Drag to orbit, Shift+drag or right-drag to pan, scroll to zoom. Keys: arrows orbit (with Shift, pan), + and − zoom, Home resets the view, W toggles the wireframe, comma and full stop move the light</source>
            <translation>Ziehen dreht, Umschalt+Ziehen oder Ziehen mit der rechten Taste verschiebt, das Mausrad zoomt. Tasten: Pfeile drehen (mit Umschalt verschieben), + und − zoomen, Pos1 setzt die Ansicht zurück, W schaltet das Drahtgitter um, Komma und Punkt bewegen das Licht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/threshold_view.py" />
            <source>Drag, or press the arrow keys (Shift: finer steps).</source>
            <translation>Ziehen oder Pfeiltasten drücken (Umschalt: feiner).</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/head_view.py" />
            <source>Draw only the edges of the mesh (W)</source>
            <translation>Nur die Kanten des Meshs zeichnen (W)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Driven by</source>
            <translation>Gesteuert durch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/head_view.py" />
            <source>Driver of the head</source>
            <translation>Steuerung des Kopfes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/page.py" />
            <source>Drop an audio file here, or press Ctrl+O to open one</source>
            <translation>Eine Audiodatei hierher ziehen oder mit Strg+O öffnen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_editor.py" />
            <source>Duplicate</source>
            <translation>Duplizieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/rules.py" />
            <source>duplicate a rule</source>
            <translation>Regel duplizieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_editor.py" />
            <source>Duplicate Rule</source>
            <translation>Regel duplizieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_editor.py" />
            <source>Duplicate the current rule (Ctrl+D)</source>
            <translation>Aktuelle Regel duplizieren (Strg+D)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Duration</source>
            <translation>Dauer</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>duration</source>
            <translation>Dauer</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>Duration of the averaged frames in seconds</source>
            <translation>Dauer der gemittelten Frames in Sekunden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Duration of the sweep</source>
            <translation>Dauer des Gleittons</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/take_list.py" />
            <source>Duration of the trimmed part in seconds</source>
            <translation>Dauer des zugeschnittenen Teils in Sekunden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Dutch</source>
            <translation>Niederländisch</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/key_layer.py" />
            <source>each key follows the one before, found {early} s; sort them, one at each time</source>
            <translation>Jeder Keyframe folgt auf den vorigen, gefunden {early} s; sortieren, je Zeit nur einer</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/mesh.py" />
            <source>each triangle names one of {made} materials, and one does not; export it again</source>
            <translation>Jedes Dreieck nennt eins von {made} Materialien, eines nicht; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Edit Keys</source>
            <translation>Keyframes bearbeiten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/preset_dialogs.py" />
            <source>edit notes</source>
            <translation>Notizen bearbeiten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Edit the curves of single blend shapes by their keys.</source>
            <translation>Die Kurven einzelner Blendshapes über ihre Keyframes bearbeiten.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Edit the style of side {side} below</source>
            <translation>Den Stil der Seite {side} unten bearbeiten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Edited keys</source>
            <translation>Bearbeitete Keyframes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Effect of a slider on everything else</source>
            <translation>Wirkung eines Reglers auf alles andere</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Eleven mouth shapes</source>
            <translation>Elf Mundformen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/preset_choice.py" />
            <source>Encoder</source>
            <translation>Encoder</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>encoder, look-ahead {ms} ms</source>
            <translation>Encoder, Vorausschau {ms} ms</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>End frequency of the sweep</source>
            <translation>Endfrequenz des Gleittons</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>End guided calibration</source>
            <translation>Geführte Kalibrierung beenden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>End Label at Cursor</source>
            <translation>Beschriftung am Cursor beenden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>End Selection at Cursor</source>
            <translation>Auswahl am Cursor beenden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>End the marked range at the playback position (])</source>
            <translation>Markierten Bereich an der Abspielposition beenden (])</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>energy {range}</source>
            <translation>Energie {range}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>energy {range} / all</source>
            <translation>Energie {range} / alles</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/phoneme_view.py" />
            <source>Energy: sum of the amplitudes of the spectrum before denoise and normalise</source>
            <translation>Energie: Summe der Amplituden des Spektrums vor Entrauschen und Normieren</translation>
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
            <location filename="../../../phonemeanalyser/desktop/session/sources.py" />
            <source>Enter a text on the Talk page and press Ctrl+Return</source>
            <translation>Auf der Seite Sprechen einen Text eingeben und Strg+Eingabetaste drücken</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/score_strip.py" />
            <source>Enter in Talk what is said, align it, and save the TextGrid beside the sound</source>
            <translation>Auf „Sprechen“ den gesprochenen Text eingeben, ausrichten und als TextGrid neben der Datei speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/score_strip.py" />
            <source>Enter Script</source>
            <translation>Text eingeben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Esc</source>
            <translation>Esc</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/espeak.py" />
            <source>espeak-ng cannot be loaded ({error}); install it again</source>
            <translation>espeak-ng lässt sich nicht laden ({error}); neu installieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/espeak.py" />
            <source>espeak-ng cannot load its voice {identifier}; install espeak-ng again</source>
            <translation>espeak-ng kann die Sprechstimme {identifier} nicht laden; espeak-ng neu installieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/espeak.py" />
            <source>espeak-ng cannot speak this text (its error {failed}); write it otherwise</source>
            <translation>espeak-ng kann diesen Text nicht sprechen (Fehler {failed}); anders schreiben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/espeak.py" />
            <source>espeak-ng does not find its data; install it again: {partition}</source>
            <translation>espeak-ng findet seine Daten nicht; neu installieren: {partition}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/espeak.py" />
            <source>espeak-ng reads its data from paths of at most {longest_path} bytes, and both {data} and {short} are longer; install the program in a folder with a shorter path</source>
            <translation>espeak-ng liest seine Daten nur aus Pfaden bis {longest_path} Byte; {data} und {short} sind länger; Programm in einem Ordner mit kürzerem Pfad installieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/phoneme_view.py" />
            <source>Estimated probability that the phoneme is right, fitted on labelled speech: of 100 answers with 80 %, 80 are right</source>
            <translation>Geschätzte Wahrscheinlichkeit, dass das Phonem stimmt, an beschrifteter Sprache ermittelt: Von 100 Antworten mit 80 % stimmen 80</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Estonian</source>
            <translation>Estnisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/time_view.py" />
            <source>Everything loaded</source>
            <translation>Alles Geladene</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Exclude</source>
            <translation>Ausschließen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Exclude or include take</source>
            <translation>Take aus- oder einschließen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Exclude the selected takes from calibration, or include them again (X)</source>
            <translation>Ausgewählte Takes von der Kalibrierung ausschließen oder wieder einschließen (X)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_model.py" />
            <source>exclude {n} takes</source>
            <translation>{n} Takes ausschließen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>exclude {take}</source>
            <translation>Auslassen von {take}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/take_list.py" />
            <source>excluded</source>
            <translation>ausgeschlossen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Existing files may have been edited by hand or made with other settings.</source>
            <translation>Vorhandene Dateien wurden vielleicht von Hand bearbeitet oder mit anderen Einstellungen erstellt.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>Expected '=' after a key in a key/value pair</source>
            <translation>'=' nach dem Schlüssel erwartet</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>Expected newline or end of document after a statement</source>
            <translation>Zeilenende nach der Anweisung erwartet</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>Expecting ',' delimiter</source>
            <translation>',' erwartet</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>Expecting property name enclosed in double quotes</source>
            <translation>Name in doppelten Anführungszeichen erwartet</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>Expecting value</source>
            <translation>Wert erwartet</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Export</source>
            <translation>Exportieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>Export Differences as CSV</source>
            <translation>Unterschiede als CSV exportieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>Export Differences as CSV…</source>
            <translation>Unterschiede als CSV exportieren…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>Export Levels as CSV</source>
            <translation>Pegel als CSV exportieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>Export Levels as CSV…</source>
            <translation>Pegel als CSV exportieren…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Export Only the Others</source>
            <translation>Nur die anderen exportieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Export the animation for Blender, Unreal, Unity or Moho, or as a clip.</source>
            <translation>Die Animation für Blender, Unreal, Unity oder Moho oder als Clip exportieren.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Export the animation for other programs, as the head shows it (Ctrl+Shift+E)</source>
            <translation>Animation für andere Programme exportieren, wie der Kopf sie zeigt (Strg+Umschalt+E)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Export…</source>
            <translation>Exportieren…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Expression</source>
            <translation>Ausdruck</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Expression that the face shows along with the speech</source>
            <translation>Ausdruck, den das Gesicht zusätzlich zur Sprache zeigt</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/expression/composer.py" />
            <source>expressions move the blend shapes of ARKit, which are not those of the table {table}; choose another table, such as arkit</source>
            <translation>Ausdrücke bewegen die Blendshapes von ARKit, die Tabelle {table} hat andere; andere Tabelle wählen, etwa arkit</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>External program</source>
            <translation>Externes Programm</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>Extra data</source>
            <translation>Überzählige Daten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/score_strip.py" />
            <source>F1 of each phoneme since this change began, in percentage points: {phonemes}</source>
            <translation>F1 je Phonem seit Beginn dieser Änderung, in Prozentpunkten: {phonemes}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Face</source>
            <translation>Gesicht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Face captures of Live Link Face or OpenFace (*.csv)</source>
            <translation>Aufzeichnungen von Live Link Face oder OpenFace (*.csv)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Face follows the text</source>
            <translation>Gesicht folgt dem Text</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Face mesh of the exported files</source>
            <translation>Gesichts-Mesh der exportierten Dateien</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Face meshes and blend shapes ({endings})</source>
            <translation>Gesichts-Meshes und Blendshapes ({endings})</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Face network</source>
            <translation>Gesichtsnetz</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Face networks (*.face)</source>
            <translation>Gesichtsnetze (*.face)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Factor of the time for which the pose holds, comes and goes</source>
            <translation>Faktor der Zeit, in der die Pose kommt, gehalten wird und geht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/preset_dialogs.py" />
            <source>Factory</source>
            <translation>Mitgeliefert</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Fades each window in and out, which keeps a tone within few bins. Off: rectangle.</source>
            <translation>Blendet jedes Fenster ein und aus; so bleibt ein Ton in wenigen Frequenzstufen. Aus: Rechteck.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Fades out from the start to the end and removes frequencies above.</source>
            <translation>Blendet vom Anfang bis zum Ende aus und entfernt Frequenzen darüber.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/exports.py" />
            <source>failed</source>
            <translation>gescheitert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/figures.py" />
            <source>False silence</source>
            <translation>Falsche Stille</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>false silence rises from {old} % to {new} %</source>
            <translation>falsche Stille steigt von {old} % auf {new} %</translation>
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
            <location filename="../../../phonemeanalyser/desktop/talk/words/spoken_lanes.py" />
            <source>Feeling</source>
            <translation>Gefühl</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/sonagram.py" />
            <source>Feeling in the voice (lane below: activation, pleasantness, standard errors)</source>
            <translation>Gefühl in der Stimme (Spur darunter: Aktivierung, Angenehmheit, Standardfehler)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>female</source>
            <translation>weiblich</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/encoder/model_folder.py" />
            <source>fetching needs the package huggingface_hub, which is missing; pip install "phonemeanalyser[whisper]", or name a folder</source>
            <translation>Zum Herunterladen fehlt das Paket huggingface_hub; pip install "phonemeanalyser[whisper]" ausführen oder einen Ordner angeben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/sources.py" />
            <source>File</source>
            <translation>Datei</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>File exists</source>
            <translation>Datei ist schon vorhanden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>file is not a database</source>
            <translation>keine Datenbank</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/preset_choice.py" />
            <source>File model</source>
            <translation>Modell für Dateien</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>File name too long</source>
            <translation>Dateiname zu lang</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_view.py" />
            <source>File over time</source>
            <translation>Datei über der Zeit</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Files</source>
            <translation>Dateien</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_model.py" />
            <source>Files that were changed were kept under another name, such as {name}.</source>
            <translation>Geänderte Dateien bleiben unter anderem Namen erhalten, zum Beispiel {name}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Fill Gaps with Silence (and Mark Them)</source>
            <translation>Lücken mit Stille füllen (und markieren)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>filtered</source>
            <translation>gefiltert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>Filters</source>
            <translation>Filter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>Filters through which the sound was averaged; only curves with the same filters can be compared</source>
            <translation>Filter, durch die das Signal gemittelt wurde; nur Kurven mit gleichen Filtern lassen sich vergleichen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>Find a few rules in the loaded takes and recordings</source>
            <translation>In den geladenen Takes und Aufnahmen wenige Regeln suchen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_editor.py" />
            <source>Find a few rules in the loaded takes and recordings, on the Calibrate page</source>
            <translation>In den geladenen Takes und Aufnahmen wenige Regeln suchen, auf der Seite Kalibrieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>Find Rules</source>
            <translation>Regeln suchen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Find the words of the text in the recording (Ctrl+Shift+Return)</source>
            <translation>Die Wörter des Textes in der Aufnahme finden (Strg+Umschalt+Eingabetaste)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>Finds a small decision tree for the loaded takes and recordings, as rules to read and edit.</source>
            <translation>Sucht einen kleinen Entscheidungsbaum für die geladenen Takes und Aufnahmen, als Regeln zum Lesen und Bearbeiten.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Finds the most likely sequence of phonemes within the look-ahead, from the results of the rules and from how phonemes follow each other in the language.</source>
            <translation>Findet innerhalb der Vorausschau die wahrscheinlichste Folge von Phonemen, aus den Ergebnissen der Regeln und daraus, wie Phoneme in der Sprache aufeinander folgen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Finds the thresholds with which the most frames of the loaded takes and recordings are recognised correctly.</source>
            <translation>Findet die Schwellen, mit denen die meisten Frames der geladenen Takes und Aufnahmen richtig erkannt werden.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Finnish</source>
            <translation>Finnisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Firm</source>
            <translation>Fest</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>First formant</source>
            <translation>Erster Formant</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>First Steps…</source>
            <translation>Erste Schritte…</translation>
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
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_view.py" />
            <source>Fit All</source>
            <translation>Alles einpassen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/phoneme_data_panel.py" />
            <source>Fit All Numbers</source>
            <translation>Alle Zahlen anpassen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/phoneme_data_panel.py" />
            <source>Fit all thresholds to the loaded takes and recordings; Ctrl+Z restores the old ones</source>
            <translation>Alle Schwellen an die geladenen Takes und Aufnahmen anpassen; Strg+Z stellt die alten wieder her</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/phoneme_data_panel.py" />
            <source>Fit Number</source>
            <translation>Zahl anpassen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_view.py" />
            <source>Fit Selection</source>
            <translation>Auswahl einpassen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/phoneme_data_panel.py" />
            <source>Fit the number of the selected row, with all others as they are</source>
            <translation>Die Zahl der gewählten Zeile anpassen, alle anderen bleiben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/phoneme_data_panel.py" />
            <source>Fit the numbers to one speaker, or read them from a file, for voices in one range of pitch; Ctrl+Z removes the set</source>
            <translation>Die Zahlen an einen Sprecher anpassen oder aus einer Datei lesen, für Stimmen eines Grundfrequenzbereichs; Strg+Z entfernt den Satz</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Fit Thresholds</source>
            <translation>Schwellen anpassen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Fit to Recorded Faces</source>
            <translation>An aufgezeichnete Gesichter anpassen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Fit to view</source>
            <translation>Einpassen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/phoneme_data_model.py" />
            <source>fit {what}</source>
            <translation>{what} anpassen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/stream.py" />
            <source>fits several</source>
            <translation>passt zu mehreren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/performance_model.py" />
            <source>Fitting: {progress:.0%}</source>
            <translation>Anpassung: {progress:.0%}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Five mouth shapes</source>
            <translation>Fünf Mundformen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>FLAC (half the size)</source>
            <translation>FLAC (halb so groß)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Folder</source>
            <translation>Ordner</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Folder for Exported Files</source>
            <translation>Ordner für exportierte Dateien</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Folder for the exported files</source>
            <translation>Ordner für die exportierten Dateien</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Folder in which takes are saved</source>
            <translation>Ordner, in dem Takes gespeichert werden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Folder of Labelled Recordings…</source>
            <translation>Ordner mit beschrifteten Aufnahmen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/exports.py" />
            <source>folder of PNG pictures of the head</source>
            <translation>Ordner mit PNG-Bildern des Kopfes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>Folder to Average</source>
            <translation>Ordner mitteln</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>Folder: {name}</source>
            <translation>Ordner: {name}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>Folder…</source>
            <translation>Ordner…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_view.py" />
            <source>Follow</source>
            <translation>Folgen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/sonagram.py" />
            <source>Formants (red dots, Burg's method, as in Praat)</source>
            <translation>Formanten (rote Punkte, nach Burg, wie in Praat)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/sonagram.py" />
            <source>Formants: zoom in to {n:.0f} s or less</source>
            <translation>Formanten: auf höchstens {n:.0f} s hineinzoomen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Format</source>
            <translation>Format</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Format default</source>
            <translation>Standard des Formats</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Format of the exported files</source>
            <translation>Format der exportierten Dateien</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Forward 1 s</source>
            <translation>1 s vor</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Forward 10 ms</source>
            <translation>10 ms vor</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Frame rate</source>
            <translation>Bildrate</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>Frames analysed but never drawn since playback or listening began: the computer is overloaded</source>
            <translation>Frames, die seit Beginn der Wiedergabe oder des Zuhörens analysiert, aber nie gezeichnet wurden: Der Computer ist überlastet</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/figures_table.py" />
            <source>Frames of 10 ms with A and with B, and which phonemes B gives</source>
            <translation>Frames von 10 ms mit A und mit B, und welche Phoneme B ergibt</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/animation.py" />
            <source>frames per second</source>
            <translation>Bilder je Sekunde</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Frames per second of the exported animation</source>
            <translation>Bilder pro Sekunde der exportierten Animation</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/figures_table.py" />
            <source>Frames whose phoneme changes</source>
            <translation>Frames, deren Phonem sich ändert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>frames/s</source>
            <translation>Bilder/s</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>free some space or record to another disk</source>
            <translation>Platz schaffen oder auf ein anderes Laufwerk aufnehmen</translation>
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
            <translation>Frequenzglättung</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Frequencies above are removed.</source>
            <translation>Frequenzen darüber werden entfernt.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Frequencies above pass unchanged.</source>
            <translation>Frequenzen darüber bleiben unverändert.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Frequencies below are removed.</source>
            <translation>Frequenzen darunter werden entfernt.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Frequencies below pass unchanged.</source>
            <translation>Frequenzen darunter bleiben unverändert.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/sonagram.py" />
            <source>Frequencies, window, levels and colour map of the sonagram</source>
            <translation>Frequenzen, Fenster, Pegel und Farbtabelle des Sonagramms</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/frame_views.py" />
            <source>Frequency</source>
            <translation>Frequenz</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/sonagram.py" />
            <source>Frequency axis</source>
            <translation>Frequenzachse</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>Frequency bands</source>
            <translation>Frequenzbänder</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Frequency of the sine wave</source>
            <translation>Frequenz des Sinustons</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Frequency of the sine wave on a logarithmic scale</source>
            <translation>Frequenz des Sinustons auf logarithmischer Skala</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Frequency of the sine wave; arrow keys: by a semitone, page keys: by an octave</source>
            <translation>Frequenz des Sinustons; Pfeiltasten: um einen Halbton, Bildtasten: um eine Oktave</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>From</source>
            <translation>Von</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>from</source>
            <translation>von</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>from </source>
            <translation>von </translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>From the style of side A to that of side B</source>
            <translation>Vom Stil der Seite A zu dem der Seite B</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>from two packages</source>
            <translation>aus zwei Paketen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>Frozen</source>
            <translation>Eingefroren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Full Screen</source>
            <translation>Vollbild</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/phoneme_view.py" />
            <source>Fundamental frequency of a voice, 60 to 500 Hz; a higher tone has none</source>
            <translation>Grundfrequenz einer Stimme, 60 bis 500 Hz; ein höherer Ton hat keine</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Fundamental frequency of the vowel</source>
            <translation>Grundfrequenz des Vokals</translation>
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
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/frame_views.py" />
            <source>Gain</source>
            <translation>Gain</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/rule_dialogs.py" />
            <source>Gain: {sounds}</source>
            <translation>Gewinn: {sounds}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/score_strip.py" />
            <source>Gained: {phonemes}</source>
            <translation>Besser: {phonemes}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/keys/key_lanes.py" />
            <source>Generating curves…</source>
            <translation>Kurven werden erzeugt…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/driver_model.py" />
            <source>Generating the face from the sound: {progress:.0%}</source>
            <translation>Gesicht wird aus dem Ton erzeugt: {progress:.0%}</translation>
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
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Gestures of the head</source>
            <translation>Gesten des Kopfes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Give your own style and its file another name</source>
            <translation>Dem eigenen Stil und seiner Datei einen anderen Namen geben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>go on in a new file, or on a disk formatted as exFAT or NTFS</source>
            <translation>in einer neuen Datei fortfahren oder auf einem Laufwerk mit exFAT oder NTFS</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/score_strip.py" />
            <source>Go to an example of this confusion</source>
            <translation>Zu einem Beispiel dieser Verwechslung springen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Go to End</source>
            <translation>Zum Ende</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Go to Start</source>
            <translation>Zum Anfang</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/comparison.py" />
            <source>Go to the next difference of the list</source>
            <translation>Zum nächsten Unterschied der Liste gehen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/time_line.py" />
            <source>Go to the next poor match</source>
            <translation>Zum nächsten schlecht passenden Wort</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/tour.py" />
            <source>Go to the next step (Return)</source>
            <translation>Zum nächsten Schritt gehen (Eingabetaste)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/comparison.py" />
            <source>Go to the previous difference of the list</source>
            <translation>Zum vorigen Unterschied der Liste gehen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/time_line.py" />
            <source>Go to the previous poor match</source>
            <translation>Zum vorigen schlecht passenden Wort</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/tour.py" />
            <source>Go to the step before</source>
            <translation>Zum vorigen Schritt gehen</translation>
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
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Guided calibration</source>
            <translation>Geführte Kalibrierung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Guided Calibration…</source>
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
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Hawaiian</source>
            <translation>Hawaiianisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/head_view.py" />
            <source>Head</source>
            <translation>Kopf</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Head follows the voice</source>
            <translation>Kopf folgt der Stimme</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/curves_file.py" />
            <source>head has {columns} values and curves {n_frames}; export the curves again</source>
            <translation>head hat {columns} Werte, curves {n_frames}; Kurven neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/curves_file.py" />
            <source>head knows no angle {strange}; export the curves again</source>
            <translation>head kennt keinen Winkel {strange}; Kurven neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Head motion</source>
            <translation>Kopfbewegung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Head, while it has the focus</source>
            <translation>Kopf, solange er den Fokus hat</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Hebrew</source>
            <translation>Hebräisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Height</source>
            <translation>Höhe</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Height of the picture, pixels</source>
            <translation>Höhe des Bildes in Pixeln</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Held out</source>
            <translation>Ausgelassen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>Hide</source>
            <translation>Ausblenden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>high</source>
            <translation>hoch</translation>
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
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/sonagram.py" />
            <source>Highest frequency</source>
            <translation>Höchste Frequenz</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>highest peak</source>
            <translation>höchste Spitze</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/phoneme_data_panel.py" />
            <source>Highest pitch of the voices that this set is for</source>
            <translation>Höchste Grundfrequenz der Stimmen, für die dieser Satz gilt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/scroll_view.py" />
            <source>History</source>
            <translation>Verlauf</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/score_strip.py" />
            <source>Hold a key in Calibrate while you say a sound</source>
            <translation>Auf „Kalibrieren“ eine Taste gedrückt halten und den Laut sprechen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Hold a key or button and say its sound</source>
            <translation>Taste halten und ihren Laut sprechen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Hold a key while its sound plays</source>
            <translation>Taste halten, solange ihr Laut erklingt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Hold mouth shape</source>
            <translation>Mundform halten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>Hold the a in “father”</source>
            <translation>Das a in „Vater“ halten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Hold the button or the {key} key while you say {name}, or while it sounds in the playing file</source>
            <translation>Schaltfläche oder Taste {key} halten, solange {name} gesprochen wird oder in der laufenden Datei klingt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>Hold the e in “bed”</source>
            <translation>Das e in „Bett“ halten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>Hold the ee in “see”</source>
            <translation>Das ie in „sieh“ halten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Hold the mouth shape {shape}</source>
            <translation>Mundform {shape} halten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>Hold the o in “more”</source>
            <translation>Das o in „Ofen“ halten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>Hold the oo in “food”</source>
            <translation>Das u in „du“ halten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>Hold the s in “see”</source>
            <translation>Das s in „Fuß“ halten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>Hold the sh in “she”</source>
            <translation>Das sch in „schön“ halten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Hold to show the mouth shape {shape} instead of the speech</source>
            <translation>Halten, um die Mundform {shape} statt der Sprache zu zeigen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Hold to show the mouth shape {shape} instead of the speech (keys: {keys})</source>
            <translation>Halten, um die Mundform {shape} statt der Sprache zu zeigen (Tasten: {keys})</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Home</source>
            <translation>Pos1</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>hop</source>
            <translation>Schritt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>How closely the mouth follows the speech; distant faces need less detail</source>
            <translation>Wie genau der Mund der Sprache folgt; ferne Gesichter brauchen weniger Details</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>How far the face shows what the text says of feeling: [smile], [angry 0.6], emoji, good and bad words; the lane Feeling of the timeline shows and edits it</source>
            <translation>Wie weit das Gesicht zeigt, was der Text an Gefühl sagt: [smile], [angry 0.6], Emojis, gute und schlechte Wörter; die Spur Gefühl der Zeitleiste zeigt und ändert es</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>How far this follows the voice: lively, loud and high speech lifts, relaxed speech lowers, each compared with the speaker’s usual voice</source>
            <translation>Wie weit dies der Stimme folgt: Lebhaftes, lautes und hohes Sprechen hebt, entspanntes senkt, jeweils verglichen mit der gewohnten Stimme des Sprechers</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>How long the recogniser may wait for what follows a frame: longer is more accurate, but adds latency. Rules need none without a decoder.</source>
            <translation>Wie lange der Erkenner auf das warten darf, was einem Frame folgt: Länger ist genauer, erhöht aber die Latenz. Regeln brauchen ohne Decoder keine.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>How long the recogniser of files may wait for what follows a frame: longer is more accurate.</source>
            <translation>Wie lange der Erkenner bei Dateien auf das warten darf, was einem Frame folgt: Länger ist genauer.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>How long the recogniser of the microphone may wait for what follows a frame: longer is more accurate, but delays the mouth.</source>
            <translation>Wie lange der Erkenner beim Mikrofon auf das warten darf, was einem Frame folgt: Länger ist genauer, verzögert aber den Mund.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>How much is in the picture</source>
            <translation>Was im Bild zu sehen ist</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>How much of the lips and the jaw speech controls; the expression controls the rest. At 50 %, both are applied in full</source>
            <translation>Wie viel von Lippen und Kiefer die Sprache steuert; den Rest steuert der Ausdruck. Bei 50 % wirken beide ganz</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>How much speech reduces the expression now: it fades within 0.1 s when speech starts, and returns within 0.5 s</source>
            <translation>Wie stark die Sprache den Ausdruck gerade reduziert: Mit Beginn der Sprache lässt er in 0.1 s nach und kehrt danach in 0.5 s zurück</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/score_strip.py" />
            <source>How often the recognised phoneme changes, and in parentheses how often the labels do</source>
            <translation>Wie oft das erkannte Phonem wechselt, und in Klammern die Beschriftung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/figures.py" />
            <source>How often the recognised phoneme changes; more often than the labels do is flicker</source>
            <translation>Wie oft das erkannte Phonem wechselt; häufiger als die Beschriftung ist Flackern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/feeling_lane.py" />
            <source>How the voice differs from the speaker's usual voice, −1 to 1: activation (level, pitch, range, rate, spectral tilt) and, far less certain, pleasantness. The band is the standard error; it fills the lane where nothing is known: before the first voiced second, in pauses, in a whisper. The lane identifies no emotion: anger and joy both raise activation.</source>
            <translation>Wie sich die Stimme von der gewohnten Stimme des Sprechers unterscheidet, −1 bis 1: Aktivierung (Pegel, Tonhöhe, Umfang, Tempo, spektrale Neigung) und, weit weniger sicher, Angenehmheit. Das Band ist der Standardfehler; es füllt die Spur, wo nichts bekannt ist: vor der ersten stimmhaften Sekunde, in Pausen, beim Flüstern. Die Spur bestimmt keine Emotion: Ärger und Freude erhöhen beide die Aktivierung.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>Hum with your lips closed</source>
            <translation>Mit geschlossenen Lippen summen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Hungarian</source>
            <translation>Ungarisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Icelandic</source>
            <translation>Isländisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Idle motion</source>
            <translation>Ruhebewegung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>if all hold</source>
            <translation>wenn alle gelten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Improved on the loaded data, but not on a {left_out} left out of the fit. Load more data.</source>
            <translation>Verbessert bei den geladenen Daten, aber nicht bei ausgelassenen ({left_out}). Mehr Daten laden.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Improved on the loaded recording. With one alone nothing can be held out. Load more data.</source>
            <translation>Besser auf der geladenen Aufnahme. Bei nur einer lässt sich nichts zurückhalten. Mehr Daten laden.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Improved. The last column is cross-validated: each {left_out} in turn is left out of the fit and used for measuring.</source>
            <translation>Verbessert. Die letzte Spalte ist kreuzvalidiert: Reihum bleibt ein Teil ({left_out}) beim Anpassen außen vor und dient zum Messen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>in </source>
            <translation>in </translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/phoneme_data_panel.py" />
            <source>In bins of 21.53 Hz, as in a PhonemeData file</source>
            <translation>In Bins von 21.53 Hz, wie in einer PhonemeData-Datei</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>in the data of the program</source>
            <translation>in den Daten des Programms</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/mapping_dialog.py" />
            <source>In this face</source>
            <translation>In diesem Gesicht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>In use: the preset's own numbers, since no pitch set has {pitch:.0f} Hz, the pitch of the voice.</source>
            <translation>Verwendet: die Zahlen des Presets, da kein Grundfrequenz-Satz {pitch:.0f} Hz enthält, die Grundfrequenz der Stimme.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>In use: the preset's own numbers, until the pitch of the voice is known.</source>
            <translation>Verwendet: die Zahlen des Presets, bis die Grundfrequenz der Stimme bekannt ist.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>In use: {name} ({low:.0f}–{high:.0f} Hz), since the pitch of the voice is {pitch:.0f} Hz, the median of its last second.</source>
            <translation>Verwendet: {name} ({low:.0f}–{high:.0f} Hz), da die Grundfrequenz der Stimme {pitch:.0f} Hz ist, der Median ihrer letzten Sekunde.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/preset_choice.py" />
            <source>In use: {words}.</source>
            <translation>Aktiv: {words}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/time_view.py" />
            <source>In view</source>
            <translation>Sichtbar</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Include</source>
            <translation>Einschließen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_model.py" />
            <source>include {n} takes</source>
            <translation>{n} Takes einschließen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>include {take}</source>
            <translation>Mitzählen von {take}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Includes</source>
            <translation>Enthält</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Indonesian</source>
            <translation>Indonesisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>Input/output error</source>
            <translation>Ein-/Ausgabefehler</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Insert Label</source>
            <translation>Beschriftung einfügen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/label_tiers.py" />
            <source>insert label</source>
            <translation>Beschriftung einfügen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Insert Word (Ins)</source>
            <translation>Wort einfügen (Einfg)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/sound_words.py" />
            <source>insertion of a word</source>
            <translation>Einfügen eines Wortes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Inspect</source>
            <translation>Prüfen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Intensity</source>
            <translation>Intensität</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/phoneme_view.py" />
            <source>Intensity of the current frame: 0 to 1 between the two levels of the filter Intensity</source>
            <translation>Intensität des aktuellen Frames: 0 bis 1 zwischen den beiden Pegeln des Filters Intensität</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/phoneme_view.py" />
            <source>Intensity {intensity:.2f}</source>
            <translation>Intensität {intensity:.2f}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/app.py" />
            <source>Internal error. Details are in {log}; send that file with your report.</source>
            <translation>Interner Fehler. Einzelheiten stehen in {log}; diese Datei bitte der Fehlermeldung beilegen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>Invalid statement</source>
            <translation>Ungültige Anweisung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>Invalid value</source>
            <translation>Ungültiger Wert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>Is a directory</source>
            <translation>Ist ein Ordner</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>is never reached: an earlier rule holds wherever this one does</source>
            <translation>wird nie erreicht: eine frühere Regel gilt überall, wo diese gilt</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/stream.py" />
            <source>is not connected</source>
            <translation>ist nicht angeschlossen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/containers.py" />
            <source>it cannot be opened</source>
            <translation>lässt sich nicht öffnen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/storage/files.py" />
            <source>it cannot be read ({cause}); check the file</source>
            <translation>Nicht lesbar ({cause}); Datei prüfen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/headers.py" />
            <source>it claims {claimed} bytes, {length} are there</source>
            <translation>angegeben sind {claimed} Byte, vorhanden {length}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/threedm.py" />
            <source>it ends after line {number}; it is cut off, export or copy it again</source>
            <translation>Sie endet nach Zeile {number}; abgeschnitten, neu exportieren oder kopieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/threedm.py" />
            <source>it ends before {what}; it is cut off, export or copy it again</source>
            <translation>Die Datei endet vor: {what}; abgeschnitten, neu exportieren oder kopieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/encoder/weights.py" />
            <source>it ends too early</source>
            <translation>endet zu früh</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/headers.py" />
            <source>it ends within its header</source>
            <translation>endet mitten in den Kopfdaten</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>it ends within its header; it is cut off, export or copy it again</source>
            <translation>Sie endet mitten in den Kopfdaten; abgeschnitten, neu exportieren oder kopieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/headers.py" />
            <source>it has more than {most_chunks} chunks</source>
            <translation>mehr als {most_chunks} Blöcke</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/x_file.py" />
            <source>it has more than {most_meshes} meshes; join them</source>
            <translation>Mehr als {most_meshes} Meshs; zusammenfassen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>it has no JSON part; export it again</source>
            <translation>Kein JSON-Teil enthalten; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/containers.py" />
            <source>it has too many packets</source>
            <translation>zu viele Pakete</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/containers.py" />
            <source>it is damaged</source>
            <translation>beschädigt</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/encoder/weights.py" />
            <source>it is no Whisper model of CTranslate2 in version {version} of the format</source>
            <translation>kein Whisper-Modell von CTranslate2 in Version {version} des Formats</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/conversion/spoken_texts.py" />
            <source>it is of one sound, and there are {sounds}; name that sound alone</source>
            <translation>enthält nur eine Audiodatei, es sind {sounds}; nur diese angeben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>it is of version {version}, and this program reads glTF 2; export it as glTF 2</source>
            <translation>Version {version}, dieses Programm liest glTF 2; als glTF 2 exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/conversion/spoken_texts.py" />
            <source>it lasts {duration} s, and at most {longest} s are taken</source>
            <translation>Dauert {duration} s, verarbeitet werden höchstens {longest} s</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/exports/gltf.py" />
            <source>it names number {buffer} of its buffers, and there are {begins}; export it again</source>
            <translation>Nummer {buffer} der Puffer wird genannt, es gibt {begins}; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/skin.py" />
            <source>it names number {child} of its nodes, and there are {n}; export it again</source>
            <translation>Knoten Nummer {child} ist genannt, vorhanden sind {n}; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>it names number {place} of its {key}, and there are {entries}; export it again</source>
            <translation>Nummer {place} in {key} wird genannt, es gibt {entries}; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/obj.py" />
            <source>it names {what} {word}, and so far there are {n}; export it again</source>
            <translation>Genannt wird {what} {word}, bisher gibt es {n}; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/speech/program.py" />
            <source>it printed nothing</source>
            <translation>es gab nichts aus</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/variables_panel.py" />
            <source>It takes effect once a rule of the preset uses it.</source>
            <translation>Sie wirkt, sobald eine Regel des Presets sie verwendet.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>it uses more than {most_buffers} buffers; export it as .glb</source>
            <translation>Mehr als {most_buffers} Puffer; als .glb exportieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Italian</source>
            <translation>Italienisch</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/recognition/model.py" />
            <source>its arrays do not fit together; get it anew, or train it again</source>
            <translation>Die Arrays passen nicht zusammen; neu beschaffen oder neu trainieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>its buffer {uri} is not beside it; put it there, or export a .glb</source>
            <translation>Der Puffer {uri} liegt nicht daneben; dorthin legen oder als .glb exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>its buffers hold more than {largest_buffer} MB; export less</source>
            <translation>Die Puffer enthalten mehr als {largest_buffer} MB; weniger exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/exports/gltf.py" />
            <source>its buffers lie outside it</source>
            <translation>die Puffer liegen außerhalb der Datei</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/containers.py" />
            <source>its channels or its sample rate change</source>
            <translation>die Kanalzahl oder die Abtastrate ändert sich</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/containers.py" />
            <source>its codec is not known</source>
            <translation>der Codec ist unbekannt</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf.py" />
            <source>its COLOR_0 is of shape {shape}, with {n} vertices; export it again</source>
            <translation>COLOR_0 hat die Form {shape} bei {n} Eckpunkten; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/recording.py" />
            <source>its components are no list of numbers</source>
            <translation>Ihre Komponenten sind keine Liste von Zahlen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/recording.py" />
            <source>its components do not fit its shapes</source>
            <translation>Ihre Komponenten passen nicht zu ihren Formen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/recognition/model.py" />
            <source>its dilations must lie in 1..{most_dilation} frames; get it anew</source>
            <translation>Die Dilatationen müssen in 1..{most_dilation} Frames liegen; neu beschaffen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/batch/record.py" />
            <source>its disk knows no locks</source>
            <translation>das Laufwerk kennt keine Sperren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/headers.py" />
            <source>its ds64 chunk is missing</source>
            <translation>der ds64-Block fehlt</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/batch/runner.py" />
            <source>its file {name} is already that of {name_2}; rename one of them</source>
            <translation>Die Datei {name} gehört schon zu {name_2}; eine umbenennen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/exports/gltf.py" />
            <source>its first buffer lies outside it</source>
            <translation>der erste Puffer liegt außerhalb der Datei</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>its header says version {version} and {length} bytes, and it has {content}; export it again</source>
            <translation>Die Kopfdaten nennen Version {version} und {length} Byte, vorhanden sind {content}; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>its JSON is larger than {largest} MB; export a .glb, with less in it</source>
            <translation>Das JSON ist größer als {largest} MB; als .glb mit weniger Inhalt exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/headers.py" />
            <source>its last page claims {claimed} bytes, {page} are there</source>
            <translation>die letzte Seite gibt {claimed} Byte an, vorhanden sind {page}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/recognition/model.py" />
            <source>its layers do not fit together; get it anew</source>
            <translation>Die Schichten passen nicht zusammen; neu beschaffen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/table_file.py" />
            <source>its tables are not those of this program</source>
            <translation>ihre Tabellen sind nicht die dieses Programms</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_materials.py" />
            <source>its texture {name} has {size} x {size_2} pixels, and at most {longest_edge} along an edge are read; make it smaller</source>
            <translation>Die Textur {name} hat {size} x {size_2} Pixel, höchstens {longest_edge} je Kante sind lesbar; verkleinern</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>its vertices are compressed with {packed}; export it without compression</source>
            <translation>Die Eckpunkte sind mit {packed} komprimiert; unkomprimiert exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/skin.py" />
            <source>its {keys} are no bones of {n} vertices; export it again</source>
            <translation>{keys} sind keine Knochen von {n} Punkten; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/skin.py" />
            <source>its {keys} hold a number that is no weight; export it again</source>
            <translation>{keys} enthält eine Zahl, die kein Gewicht ist; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf.py" />
            <source>its {key} holds a number that is not finite; export it again</source>
            <translation>{key} enthält eine Zahl, die nicht endlich ist; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf.py" />
            <source>its {key} is of shape {shape}, and there are {n} vertices; export it again</source>
            <translation>{key} hat die Form {shape}, es gibt aber {n} Eckpunkte; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>its {key} must be a list of tables, found {found}; export it again</source>
            <translation>{key} muss eine Liste von Tabellen sein, gefunden {found}; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>its {key} must be a list, found {found}; export it again</source>
            <translation>{key} muss eine Liste sein, gefunden {found}; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>its {key} must be a table, found {found}; export it again</source>
            <translation>{key} muss eine Tabelle sein, gefunden {found}; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>its {key} must be a whole number from 0, found {found}; export it again</source>
            <translation>{key} muss eine ganze Zahl ab 0 sein, gefunden {found}; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>its {key} must be text, found {found}; export it again</source>
            <translation>{key} muss Text sein, gefunden {found}; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>its {key} must be {default} numbers, found {found}; export it again</source>
            <translation>{key} muss aus {default} Zahlen bestehen, gefunden {found}; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/exports/gltf.py" />
            <source>its {name} are no list</source>
            <translation>{name} sind keine Liste</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf.py" />
            <source>its {number} are no numbers of vertices; export it again</source>
            <translation>{number} sind keine Eckpunktnummern; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf.py" />
            <source>its {number} names a vertex twice; export it again</source>
            <translation>{number} nennt einen Eckpunkt zweimal; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/headers.py" />
            <source>its {text} chunk</source>
            <translation>der {text}-Block</translation>
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
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Keep Old Preset</source>
            <translation>Altes behalten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Keep others</source>
            <translation>Andere behalten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>Keep quiet</source>
            <translation>Nicht sprechen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Keep quiet for two seconds, then read two sentences aloud. Nothing is recorded until you press Start.</source>
            <translation>Zwei Sekunden nicht sprechen, dann zwei Sätze vorlesen. Aufgenommen wird erst nach „Start“.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Keep quiet for two seconds, then say nine sounds and read a sentence aloud. Nothing is recorded until you press Start.</source>
            <translation>Zwei Sekunden nicht sprechen, dann neun Laute sprechen und einen Satz vorlesen. Aufgenommen wird erst nach „Start“.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/model.py" />
            <source>Keep quiet: measuring the background noise for {seconds:g} seconds…</source>
            <translation>Nicht sprechen: Das Hintergrundgeräusch wird {seconds:g} Sekunden lang gemessen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Keep quiet…</source>
            <translation>Nicht sprechen…</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Keeps every n-th sample, which lowers the sample rate and keeps frequencies below half of that.</source>
            <translation>Behält jeden n-ten Abtastwert: Das senkt die Abtastrate und lässt nur Frequenzen unter deren Hälfte.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Keeps every sample, every second or every fourth.</source>
            <translation>Behält jeden, jeden zweiten oder jeden vierten Abtastwert.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Keeps everything.</source>
            <translation>Behält alles.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Keeps phonemes from flickering, by a minimum duration and by stability or a decoder. An unidentified phoneme is replaced by the most likely successor.</source>
            <translation>Verhindert, dass Phoneme flackern: durch eine Mindestdauer und durch Stabilität oder einen Decoder. Ein unbekanntes Phonem wird durch den wahrscheinlichsten Nachfolger ersetzt.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Keyboard Shortcuts</source>
            <translation>Tastenkürzel</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Keys</source>
            <translation>Keyframes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Keys edited on the Talk page, or saved beside a recording as NAME.keys.toml</source>
            <translation>Auf der Seite Sprechen bearbeitete oder neben der Aufnahme als NAME.keys.toml gespeicherte Keyframes</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/key_layer.py" />
            <source>keys lie one after the other within the sound, 0..{end} s, got {shown} s; move them</source>
            <translation>Keyframes liegen nacheinander innerhalb der Aufnahme, 0..{end} s, gefunden {shown} s; verschieben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/keys/key_lanes.py" />
            <source>Keys of blend shapes over time</source>
            <translation>Keyframes der Blendshapes im Zeitverlauf</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Keys of blend shapes, while they have the focus</source>
            <translation>Keyframes der Blendshapes, solange sie den Fokus haben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/keys/key_model.py" />
            <source>Keys saved as {path}</source>
            <translation>Keyframes gespeichert als {path}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
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
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/confusion_view.py" />
            <source>Label</source>
            <translation>Soll</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Label → error</source>
            <translation>Soll → Fehler</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/confusion_view.py" />
            <source>Label ↓</source>
            <translation>Soll ↓</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Labelled recordings used in addition to the takes</source>
            <translation>Beschriftete Aufnahmen, die zusätzlich zu den Takes verwendet werden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>labels</source>
            <translation>Soll</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Labels (*.TextGrid *.txt *.csv)</source>
            <translation>Beschriftungen (*.TextGrid *.txt *.csv)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/confusion_view.py" />
            <source>Labels and recognised phonemes</source>
            <translation>Soll und erkannte Phoneme</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/utterance.py" />
            <source>labels must end within a day ({last_end} s)</source>
            <translation>Beschriftungen müssen innerhalb eines Tages enden ({last_end} s)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/label_tiers.py" />
            <source>Labels saved as {path}</source>
            <translation>Beschriftungen gespeichert als {path}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Language</source>
            <translation>Sprache</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Language of the sentences to read</source>
            <translation>Sprache der Sätze zum Vorlesen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Language of the text</source>
            <translation>Sprache des Textes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Language of the text, those that were chosen last first; type any part of its name to find it</source>
            <translation>Sprache des Textes, die zuletzt gewählten zuerst; einen Teil des Namens eintippen, um sie zu finden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/distribution.py" />
            <source>Largest {variable} of {sound}: {value}.</source>
            <translation>Größtes {variable} von {sound}: {value}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>Latency from a sound to its phoneme on the screen: being measured</source>
            <translation>Latenz von einem Laut bis zu seinem Phonem auf dem Bildschirm: wird gemessen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>latency not measured yet</source>
            <translation>Latenz noch nicht gemessen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>latency {ms:.0f} ms</source>
            <translation>Latenz {ms:.0f} ms</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>Latency {ms:.0f} ms ({judgement})</source>
            <translation>Latenz {ms:.0f} ms ({judgement})</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>Latency: from a sound to its phoneme on the screen, measured on this computer since the program started, with the microphone used last. Mouth-shape accuracy and macro F1: of speakers the model was not trained on, measured after its training.</source>
            <translation>Latenz: von einem Laut bis zu seinem Phonem auf dem Bildschirm, auf diesem Computer seit dem Programmstart gemessen, mit dem zuletzt benutzten Mikrofon. Genauigkeit der Mundformen und Makro-F1: bei Sprechern, mit denen das Modell nicht trainiert wurde, nach dem Training gemessen.</translation>
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
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>Learned from: {parts} ({seconds:.1f} s).</source>
            <translation>Gelernt aus: {parts} ({seconds:.1f} s).</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/tour.py" />
            <source>Leave</source>
            <translation>Beenden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Leave the preset unchanged</source>
            <translation>Preset unverändert lassen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Leave the preset unchanged; the takes are kept (Escape)</source>
            <translation>Preset unverändert lassen; die Takes bleiben erhalten (Esc)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/tour.py" />
            <source>Leave the tour (Escape); Help &gt; Tour of Talk shows it again</source>
            <translation>Die Tour beenden (Esc); Hilfe &gt; Tour durch Sprechen zeigt sie wieder</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/conversion/driving.py" />
            <source>leaves the {what} of {option} unused; leave one of them out</source>
            <translation>lässt {what} von {option} ungenutzt; eines von beiden weglassen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Left</source>
            <translation>Links</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/mapping_dialog.py" />
            <source>Left over: {names}</source>
            <translation>Übrig: {names}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Left, Right</source>
            <translation>Links, Rechts</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>left-half</source>
            <translation>linke Hälfte</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Length of all attacks: 100 % as in the mouth table; less is faster, more is slower</source>
            <translation>Länge aller Attacks: 100 % wie in der Mundtabelle; weniger ist schneller, mehr langsamer</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Length of all releases: 100 % as in the mouth table; less is faster, more is slower</source>
            <translation>Länge aller Releases: 100 % wie in der Mundtabelle; weniger ist schneller, mehr langsamer</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/sonagram.py" />
            <source>Length of the sonagram's window: a short one (wide band, 6 ms) shows single pulses of the voice, a long one (narrow band, 30 ms) its harmonics</source>
            <translation>Länge des Analysefensters: Ein kurzes (breitbandig, 6 ms) zeigt einzelne Stimmimpulse, ein langes (schmalbandig, 30 ms) die Teiltöne</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/spoken_lanes.py" />
            <source>Letters</source>
            <translation>Buchstaben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/conversion/driving.py" />
            <source>letters of pinyin are those of the syllables that are said</source>
            <translation>Pinyin-Buchstaben sind die der gesprochenen Silben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>level</source>
            <translation>Pegel</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>level </source>
            <translation>Pegel </translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/frame_views.py" />
            <source>Level (dB)</source>
            <translation>Pegel (dB)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/sonagram.py" />
            <source>Level (yellow line, peaks from −80 to 0 dB)</source>
            <translation>Pegel (gelbe Linie, Spitzen von −80 bis 0 dB)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Level of detail</source>
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
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>Level of the averaged frames before the filters: root mean square, dBFS</source>
            <translation>Pegel der gemittelten Frames vor den Filtern: Effektivwert, dBFS</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/sonagram.py" />
            <source>Level of the brightest colour</source>
            <translation>Pegel der hellsten Farbe</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/sonagram.py" />
            <source>Level of the brightest colour, dBFS, the same for every sound</source>
            <translation>Pegel der hellsten Farbe in dBFS, für jeden Ton gleich</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/sonagram.py" />
            <source>Level of the darkest colour</source>
            <translation>Pegel der dunkelsten Farbe</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/sonagram.py" />
            <source>Level of the darkest colour, dBFS, the same for every sound</source>
            <translation>Pegel der dunkelsten Farbe in dBFS, für jeden Ton gleich</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Level of the highest peak</source>
            <translation>Pegel der höchsten Spitze</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_view.py" />
            <source>level {level:.0f} dB</source>
            <translation>Pegel {level:.0f} dB</translation>
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
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Licence</source>
            <translation>Lizenz</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Licences</source>
            <translation>Lizenzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Licences of all components</source>
            <translation>Lizenzen aller Bestandteile</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Lids follow the voice</source>
            <translation>Lider folgen der Stimme</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Light</source>
            <translation>Hell</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/table.py" />
            <source>like { attack = 0.1, release = 0.18 }, seconds</source>
            <translation>wie { attack = 0.1, release = 0.18 }, in Sekunden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_tree.py" />
            <source>Limit</source>
            <translation>Grenze</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Limit for {variable}; {n} conditions: {phonemes}</source>
            <translation>Grenze für {variable}; {n} Bedingungen: {phonemes}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/presets/files.py" />
            <source>line {line}: {name} must be a finite number, found {word}; correct it</source>
            <translation>Zeile {line}: {name} muss eine endliche Zahl sein, gefunden {word}; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/presets/files.py" />
            <source>line {line}: {name} must be a number, found {word}; correct it</source>
            <translation>Zeile {line}: {name} muss eine Zahl sein, gefunden {word}; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>line {number}</source>
            <translation>Zeile {number}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/obj.py" />
            <source>line {number} holds {line}, which is no number of a mesh; correct it</source>
            <translation>Zeile {number} enthält {line}, keine Zahl eines Meshs; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/threedm.py" />
            <source>line {number} is beyond the end; remove what follows</source>
            <translation>Zeile {number} liegt hinter dem Ende; den Rest entfernen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/threedm.py" />
            <source>line {number} is longer than {longest_line} bytes; this is no .3dma file</source>
            <translation>Zeile {number} ist länger als {longest_line} Byte; keine .3dma-Datei</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/obj.py" />
            <source>line {number} is longer than {longest_line} bytes; this is no .obj file</source>
            <translation>Zeile {number} ist länger als {longest_line} Byte; keine .obj-Datei</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/threedm.py" />
            <source>line {number} must begin with '{caption}:', found {found}; correct it</source>
            <translation>Zeile {number} muss mit '{caption}:' beginnen, gefunden {found}; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/threedm.py" />
            <source>line {number}: '{caption}' is said to be {word}, and there is space for {room}; correct it</source>
            <translation>Zeile {number}: '{caption}' ist mit {word} angegeben, Platz ist für {room}; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/threedm.py" />
            <source>line {number}: '{caption}' must be a whole number, found {word}; correct it</source>
            <translation>Zeile {number}: '{caption}' muss eine ganze Zahl sein, gefunden {word}; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/obj.py" />
            <source>line {number}: {error}</source>
            <translation>Zeile {number}: {error}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>linear</source>
            <translation>linear</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/threedm.py" />
            <source>lines {begin}..{number} hold a number that is not finite; correct it</source>
            <translation>Die Zeilen {begin}..{number} enthalten eine Zahl, die nicht endlich ist; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/threedm.py" />
            <source>lines {begin}..{number} must begin with vertex numbers; correct them</source>
            <translation>Die Zeilen {begin}..{number} müssen mit Eckpunktnummern beginnen; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/threedm.py" />
            <source>lines {begin}..{number} must each be a vertex number and three coordinates; correct them</source>
            <translation>Die Zeilen {begin}..{number} müssen je eine Eckpunktnummer und drei Koordinaten enthalten; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Lips, teeth and tongue meet in time and fully, however quiet the speech is</source>
            <translation>Lippen, Zähne und Zunge berühren sich rechtzeitig und ganz, wie leise die Sprache auch ist</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Listen, or release the microphone</source>
            <translation>Zuhören oder das Mikrofon freigeben</translation>
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
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_view.py" />
            <source>Live</source>
            <translation>Live</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Live look-ahead</source>
            <translation>Vorausschau live</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/scroll_view.py" />
            <source>Live signal over time</source>
            <translation>Live-Signal über der Zeit</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/presets/preset.py" />
            <source>live_model is one of {live_kinds}, got {live_model}; correct it</source>
            <translation>live_model ist eins von {live_kinds}, gefunden {live_model}; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Load</source>
            <translation>Laden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Load a face mesh (.obj, .glb, .vrm, .gltf, .x) with its blend shapes (.3dm)</source>
            <translation>Gesichtsnetz (.obj, .glb, .vrm, .gltf, .x) mit seinen Blendshapes (.3dm) laden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Load a face that Live Link Face or OpenFace captured (CSV), and show it along with the speech, in sync with the audio</source>
            <translation>Ein mit Live Link Face oder OpenFace aufgezeichnetes Gesicht (CSV) laden und synchron zum Ton zusätzlich zur Sprache zeigen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Load a file with the pronunciation of words; other words are pronounced by the rules of the language</source>
            <translation>Datei mit der Aussprache von Wörtern laden; andere Wörter werden nach den Regeln der Sprache ausgesprochen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/score_strip.py" />
            <source>Load a TextGrid, or labels of Audacity or CSV</source>
            <translation>TextGrid, Audacity-Textmarken oder CSV laden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>Load Curves</source>
            <translation>Kurven laden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>Load Curve…</source>
            <translation>Kurve laden…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Load Face</source>
            <translation>Gesicht laden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Load Face Capture</source>
            <translation>Gesichtsaufzeichnung laden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Load Face Capture…</source>
            <translation>Gesichtsaufzeichnung laden…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Load Face…</source>
            <translation>Gesicht laden…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/page.py" />
            <source>Load Labelled Recordings</source>
            <translation>Beschriftete Aufnahmen laden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Load labelled recordings: TextGrid, Audacity labels or CSV</source>
            <translation>Beschriftete Aufnahmen laden: TextGrid, Audacity-Textmarken oder CSV</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Load Labels</source>
            <translation>Beschriftungen laden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Load Labels…</source>
            <translation>Beschriftungen laden…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Load Lexicon</source>
            <translation>Lexikon laden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Load Lexicon…</source>
            <translation>Lexikon laden…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Load Mouth Table</source>
            <translation>Mundtabelle laden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Load Mouth Table…</source>
            <translation>Mundtabelle laden…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Load mouth table…</source>
            <translation>Mundtabelle laden…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/preset_picker.py" />
            <source>Load Preset or PhonemeData</source>
            <translation>Preset oder PhonemeData laden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Load Preset…</source>
            <translation>Preset laden…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Load takes or labelled recordings to compare on.</source>
            <translation>Zum Vergleichen Takes oder beschriftete Aufnahmen laden.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/head_view.py" />
            <source>Loading head…</source>
            <translation>Kopf wird geladen …</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>loading of a script</source>
            <translation>Laden eines Skripts</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Loading… {percent:.0f} %</source>
            <translation>Laden… {percent:.0f} %</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/serve_dialog.py" />
            <source>Log</source>
            <translation>Protokoll</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/distribution.py" />
            <source>log scale</source>
            <translation>log. Skala</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>log-odds</source>
            <translation>Log-Odds</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>logarithmic</source>
            <translation>logarithmisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Long Buffer: 50 ms, for a Busy Computer</source>
            <translation>Langer Puffer: 50 ms, für ausgelastete Computer</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Look at Bust</source>
            <translation>Büste ansehen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Look at Face</source>
            <translation>Gesicht ansehen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Look at Mouth</source>
            <translation>Mund ansehen</translation>
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
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>Look-ahead {ms:.0f} ms</source>
            <translation>Vorausschau {ms:.0f} ms</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/preset_choice.py" />
            <source>Looking for the model…</source>
            <translation>Modell wird gesucht…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_model.py" />
            <source>Looking for the receiver…</source>
            <translation>Empfänger wird gesucht …</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/performance_model.py" />
            <source>Looking up faces: {progress:.0%}</source>
            <translation>Gesichter werden nachgeschlagen: {progress:.0%}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Loop</source>
            <translation>Schleife</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Loop playback (L)</source>
            <translation>Wiedergabe wiederholen (L)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Loop Selection</source>
            <translation>Auswahl wiederholen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/rule_dialogs.py" />
            <source>Loss: {sounds}</source>
            <translation>Verlust: {sounds}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/score_strip.py" />
            <source>Lost: {phonemes}</source>
            <translation>Schlechter: {phonemes}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Louder</source>
            <translation>Lauter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Loudness only</source>
            <translation>Nur Lautstärke</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/level_meter.py" />
            <source>low</source>
            <translation>niedrig</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/files.py" />
            <source>low to hold speech</source>
            <translation>niedrig für Sprache</translation>
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
            <location filename="../../../phonemeanalyser/desktop/talk/keys/key_lanes.py" />
            <source>Lower Range by 0.1</source>
            <translation>Bereich um 0.1 absenken</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>lower reacts faster</source>
            <translation>niedriger reagiert schneller</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/phoneme_data_panel.py" />
            <source>Lowest pitch of the voices that this set is for</source>
            <translation>Tiefste Grundfrequenz der Stimmen, für die dieser Satz gilt</translation>
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
            <source>Macro F1</source>
            <translation>Makro-F1</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/phoneme_data_model.py" />
            <source>Macro F1 on what is loaded: {before:.1%} → {after:.1%}</source>
            <translation>Makro-F1 auf den geladenen Daten: {before:.1%} → {after:.1%}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/rule_dialogs.py" />
            <source>Macro F1 {before:.1%} → {after:.1%} on everything loaded ({minutes:.1f} min).</source>
            <translation>Makro-F1 {before:.1%} → {after:.1%} auf allem Geladenen ({minutes:.1f} min).</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>Make a frequency range a variable of your own (V): drag in the plot, then press Add</source>
            <translation>Einen Frequenzbereich als eigene Variable anlegen (V): im Diagramm ziehen, dann Neu drücken</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_editor.py" />
            <source>Make Editable</source>
            <translation>Bearbeitbar machen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/rules.py" />
            <source>make the rules editable</source>
            <translation>Regeln bearbeitbar machen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Malay</source>
            <translation>Malaiisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>male</source>
            <translation>männlich</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Maltese</source>
            <translation>Maltesisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/face_model.py" />
            <source>Man</source>
            <translation>Mann</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Manual</source>
            <translation>Handbuch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Manual pages</source>
            <translation>Seiten des Handbuchs</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/mapping_dialog.py" />
            <source>Map Blend Shapes of {face}</source>
            <translation>Blendshapes von {face} zuordnen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Map Shapes…</source>
            <translation>Blendshapes zuordnen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Map the blend shapes of this face to those of the mouth table</source>
            <translation>Die Blendshapes dieses Gesichts denen der Mundtabelle zuordnen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Mark range</source>
            <translation>Bereich markieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>max</source>
            <translation>max</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>Maximum conditions</source>
            <translation>Höchstzahl Bedingungen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>Maximum number of conditions of all rules together; fewer are easier to read</source>
            <translation>Höchstzahl der Bedingungen aller Regeln zusammen; wenige sind leichter zu lesen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>me</source>
            <translation>ich</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>mean</source>
            <translation>Mittel</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>mean amplitude</source>
            <translation>mittlere Amplitude</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>Mean latency from a sound to its phoneme on the screen, as measured now: {shares} ms. Viewers notice a picture that lags its sound by more than 45 ms, and find it unacceptable from 90 ms on (ITU-R BT.1359).</source>
            <translation>Mittlere Latenz von einem Laut bis zu seinem Phonem auf dem Bildschirm, jetzt gemessen: {shares} ms. Ein Bild, das dem Ton um mehr als 45 ms nachhinkt, fällt auf, ab 90 ms ist es inakzeptabel (ITU-R BT.1359).</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>Mean of all spectra since Play, Record or Clear; a change of the filters starts a new mean</source>
            <translation>Mittelwert aller Spektren seit Abspielen, Aufnehmen oder Leeren; eine Änderung der Filter beginnt einen neuen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/figures.py" />
            <source>Mean of the F1 scores of the ten phonemes: rare ones count as much as frequent ones</source>
            <translation>Mittelwert der F1-Werte der zehn Phoneme: Seltene zählen so viel wie häufige</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>Mean of {seconds:.1f} s since {event}</source>
            <translation>Mittel über {seconds:.1f} s seit {event}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>mean {range}</source>
            <translation>Mittel {range}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>Measure</source>
            <translation>Messgröße</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>measure</source>
            <translation>Maß</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>Measure Again With Current Filters</source>
            <translation>Mit den aktuellen Filtern neu messen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Measure background noise</source>
            <translation>Hintergrundgeräusch messen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Measure Background Noise (2 s)</source>
            <translation>Hintergrundgeräusch messen (2 s)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Measure Latency with Clicks</source>
            <translation>Latenz mit Klicks messen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Measure Noise</source>
            <translation>Geräusch messen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Measure Selection</source>
            <translation>Auswahl messen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Measure the background noise for two seconds; sets silence and denoising for every recogniser</source>
            <translation>Hintergrundgeräusch zwei Sekunden lang messen; stellt Stille und Entrauschen für jeden Erkenner ein</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>Measured by four-fold cross-validation: each quarter of your recordings ({seconds:.0f} s) in turn was left out of the calibration.</source>
            <translation>Gemessen mit vierfacher Kreuzvalidierung: Reihum blieb jedes Viertel der eigenen Aufnahmen ({seconds:.0f} s) bei der Kalibrierung außen vor.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>Measured on the test sentence only ({seconds:.1f} s), whose labels were aligned with its known text.</source>
            <translation>Nur am Testsatz gemessen ({seconds:.1f} s), dessen Beschriftung nach dem bekannten Text ausgerichtet ist.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Measurements</source>
            <translation>Messwerte</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Measurements: {start:.3f} to {end:.3f} s of {sound}</source>
            <translation>Messwerte: {start:.3f} bis {end:.3f} s von {sound}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>measuring latency</source>
            <translation>misst Latenz</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Measuring latency: playing and recording clicks for three seconds…</source>
            <translation>Latenz wird gemessen: Drei Sekunden lang werden Klicks abgespielt und aufgenommen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/curves.py" />
            <source>Measuring through the current filters…</source>
            <translation>Messung mit den aktuellen Filtern…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Measuring {percent:.0f} %</source>
            <translation>Misst {percent:.0f} %</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>Measuring…</source>
            <translation>Misst…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>Measuring… {percent:.0f} %</source>
            <translation>Misst… {percent:.0f} %</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/distribution.py" />
            <source>median</source>
            <translation>Median</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/distribution.py" />
            <source>Median {variable} of {sound}: {value}.</source>
            <translation>Median von {variable} bei {sound}: {value}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Medium Buffer: 20 ms</source>
            <translation>Mittlerer Puffer: 20 ms</translation>
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
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>Mel filter bank</source>
            <translation>Mel-Filterbank</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Menu key</source>
            <translation>Menütaste</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Menu shortcuts that are single letters, Delete, F2 or use Shift work on the Analyse page only. While a list, number or text field has the focus, letters go to that field: click a plot to leave it.</source>
            <translation>Einzelne Buchstaben, Entf, F2 und Kürzel mit Umschalt aus den Menüs wirken nur auf der Seite Analysieren. Hat eine Liste, eine Zahl oder ein Textfeld den Fokus, gehen Buchstaben dorthin: zum Verlassen in ein Diagramm klicken.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/label_tiers.py" />
            <source>merge labels</source>
            <translation>Beschriftungen verbinden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Merge with Next Label</source>
            <translation>Mit nächster Beschriftung verbinden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Merge with Previous Label</source>
            <translation>Mit vorheriger Beschriftung verbinden</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Method</source>
            <translation>Verfahren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Microphone</source>
            <translation>Mikrofon</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>microphone</source>
            <translation>Mikrofon</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Microphone (name, sound system): {name}</source>
            <translation>Mikrofon (Name, Tonsystem): {name}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/level_meter.py" />
            <source>Microphone level</source>
            <translation>Mikrofonpegel</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>Microphone Since Clear</source>
            <translation>Mikrofon seit dem Leeren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>min</source>
            <translation>min</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Minimum</source>
            <translation>Minimum</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Minimum duration</source>
            <translation>Mindestdauer</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>missing on disk</source>
            <translation>Datei fehlt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Mix</source>
            <translation>Mix</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>Model: {model}</source>
            <translation>Modell: {model}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Mono</source>
            <translation>Mono</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>More in the manual</source>
            <translation>Mehr im Handbuch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Mouth</source>
            <translation>Mund</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Mouth lead</source>
            <translation>Mund-Vorlauf</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Mouth shapes</source>
            <translation>Mundformen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Mouth table</source>
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
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>mouth-shape accuracy falls from {old} % to {new} %</source>
            <translation>Genauigkeit der Mundformen fällt von {old} % auf {new} %</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>mouth-shape accuracy {percent:.0f} % · macro F1 {macro_f1:.2f}</source>
            <translation>Genauigkeit der Mundformen {percent:.0f} % · Makro-F1 {macro_f1:.2f}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/keys/key_lanes.py" />
            <source>move a key</source>
            <translation>Keyframe verschieben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/rules.py" />
            <source>move a rule</source>
            <translation>Regel verschieben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/label_tiers.py" />
            <source>move boundary</source>
            <translation>Grenze verschieben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_editor.py" />
            <source>Move Down</source>
            <translation>Nach unten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_editor.py" />
            <source>Move down, to decide later (Alt+Down, or drag)</source>
            <translation>Nach unten, um später zu entscheiden (Alt+Ab oder ziehen)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Move key by one picture</source>
            <translation>Keyframe um ein Bild verschieben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Move light</source>
            <translation>Licht bewegen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Move Light Left (,)</source>
            <translation>Licht nach links (,)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Move Light Right (.)</source>
            <translation>Licht nach rechts (.)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/sound_words.py" />
            <source>move of a boundary ({unit})</source>
            <translation>Verschieben einer Grenze ({unit})</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/felt_text.py" />
            <source>move of a feeling</source>
            <translation>Verschieben eines Gefühls</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Move the head with the pitch and loudness of the speech</source>
            <translation>Den Kopf mit Tonhöhe und Lautstärke der Sprache bewegen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/head_view.py" />
            <source>Move the light to the left (,)</source>
            <translation>Licht nach links bewegen (,)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/head_view.py" />
            <source>Move the light to the right (.)</source>
            <translation>Licht nach rechts bewegen (.)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_editor.py" />
            <source>Move Up</source>
            <translation>Nach oben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_editor.py" />
            <source>Move up, to decide earlier (Alt+Up, or drag)</source>
            <translation>Nach oben, um früher zu entscheiden (Alt+Auf oder ziehen)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Movement of the mouth</source>
            <translation>Bewegung des Mundes</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/movestate.py" />
            <source>movestate {name} has {where} vertices and {far} offsets; export it again</source>
            <translation>Blendshape {name} hat {where} Eckpunkte und {far} Versätze; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/movestate.py" />
            <source>movestate {name} holds an offset that is no finite number; export it again</source>
            <translation>Blendshape {name} enthält einen Versatz, der keine endliche Zahl ist; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/morph_mesh.py" />
            <source>movestate {name} moves vertex {missing}, which the list of all lacks; export it again</source>
            <translation>Blendshape {name} bewegt Eckpunkt {missing}, der in der Gesamtliste fehlt; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/movestate.py" />
            <source>movestate {name} moves vertex {numbers}, and the mesh has {self}; choose the mesh that it was made for</source>
            <translation>Blendshape {name} bewegt Eckpunkt {numbers}, das Mesh hat nur {self}; das zugehörige Mesh wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/movestate.py" />
            <source>movestate {name} names vertex {numbers}, and a mesh has at most {most_vertices}; export it again</source>
            <translation>Blendshape {name} nennt Eckpunkt {numbers}, ein Mesh hat höchstens {most_vertices}; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/movestate.py" />
            <source>movestate {name} names vertex {twice} twice; export it again</source>
            <translation>Blendshape {name} nennt Eckpunkt {twice} zweimal; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/table.py" />
            <source>movestates names {name} twice; remove one</source>
            <translation>movestates nennt {name} zweimal; eins entfernen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Mumbling</source>
            <translation>Nuscheln</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Muted</source>
            <translation>Stumm</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>muted</source>
            <translation>stumm</translation>
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
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>Name</source>
            <translation>Name</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/lanes.py" />
            <source>Name of the label</source>
            <translation>Name der Beschriftung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Name of the style:</source>
            <translation>Name des Stils:</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>Name or service not known</source>
            <translation>Name unbekannt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>named by {variable}</source>
            <translation>von {variable} genannt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Nearest duration</source>
            <translation>Ähnlichste Dauer</translation>
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
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>Network is unreachable</source>
            <translation>Netzwerk nicht erreichbar</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Network that moves the face from the sound alone, also live; `phonemeanalyser performance learn` makes one of recorded faces</source>
            <translation>Netz, das das Gesicht allein aus dem Ton bewegt, auch live; `phonemeanalyser performance learn` erstellt eines aus aufgezeichneten Gesichtern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Networks trained on 249 speakers; adapts to a voice in a minute: mouth shapes {percent} % on left-out speakers.</source>
            <translation>Netze, mit 249 Sprechern trainiert; in 1 min an eine Stimme angepasst: Mundformen {percent} % bei ausgelassenen Sprechern.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Neutral</source>
            <translation>Neutral</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_tree.py" />
            <source>never decides here</source>
            <translation>entscheidet hier nie</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_tree.py" />
            <source>never holds here</source>
            <translation>gilt hier nie</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>never holds in the loaded sound</source>
            <translation>gilt im geladenen Ton nie</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_tree.py" />
            <source>never reached</source>
            <translation>nie erreicht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/serve_dialog.py" />
            <source>New</source>
            <translation>Neu</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/felt_text.py" />
            <source>new feeling</source>
            <translation>neues Gefühl</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/rule_dialogs.py" />
            <source>New rule</source>
            <translation>Neue Regel</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>New Variable</source>
            <translation>Neue Variable</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>New Variable…</source>
            <translation>Neue Variable…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/tour.py" />
            <source>Next</source>
            <translation>Weiter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Next Error</source>
            <translation>Nächster Fehler</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Next Label</source>
            <translation>Nächste Beschriftung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Next Panel</source>
            <translation>Nächster Bereich</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Next Picture (Right)</source>
            <translation>Nächstes Bild (Rechts)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Next Poor Match</source>
            <translation>Nächstes schlecht passendes Wort</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>No audio device (silent playback)</source>
            <translation>Kein Audiogerät (stumme Wiedergabe)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/model.py" />
            <source>No audio file is open. Open one to mark a range in it.</source>
            <translation>Keine Audiodatei geöffnet. Eine öffnen, um einen Bereich zu markieren.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>No audio file is open. Open the one that the labels belong to.</source>
            <translation>Es ist keine Audiodatei geöffnet. Die Datei öffnen, zu der die Beschriftungen gehören.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>No audio file is open. Open the one that you want to average.</source>
            <translation>Keine Audiodatei geöffnet. Bitte zuerst die Datei öffnen, die gemittelt werden soll.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>No audio file is open. Open the one whose phonemes you want to save.</source>
            <translation>Es ist keine Audiodatei geöffnet. Die Datei öffnen, deren Phoneme gespeichert werden sollen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>No audio file is open; open the recording of this script first, then the script.</source>
            <translation>Keine Audiodatei ist geöffnet; zuerst die Aufnahme zu diesem Skript öffnen, dann das Skript.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>No audio file is open; open the recording of this text first, then align.</source>
            <translation>Keine Audiodatei ist geöffnet; zuerst die Aufnahme dieses Textes öffnen, dann ausrichten.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>No averaged spectra yet: press Add, or load a curve. They stay here until you remove them.</source>
            <translation>Noch keine gemittelten Spektren: Hinzufügen wählen oder eine Kurve laden. Sie bleiben hier, bis sie entfernt werden.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/phoneme_data_model.py" />
            <source>No better numbers were found.</source>
            <translation>Es wurden keine besseren Zahlen gefunden.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>No better thresholds were found.</source>
            <translation>Keine besseren Schwellen gefunden.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/mapping_dialog.py" />
            <source>No blend shape is left over.</source>
            <translation>Kein Blendshape ist übrig.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>No certain label lies in this part of the recording.</source>
            <translation>In diesem Teil der Aufnahme liegt keine sichere Beschriftung.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>No clear change</source>
            <translation>Keine deutliche Änderung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/level_meter.py" />
            <source>no clipping</source>
            <translation>nicht übersteuert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/comparison.py" />
            <source>No Comparison</source>
            <translation>Kein Vergleich</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>No data yet: press Play, or add an averaged spectrum to the table</source>
            <translation>Noch keine Daten: Wiedergabe drücken oder in der Tabelle ein gemitteltes Spektrum hinzufügen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/plot.py" />
            <source>No data yet: press Play, or click in the recording</source>
            <translation>Noch keine Daten: Abspielen drücken oder in die Aufnahme klicken</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>No error after this position.</source>
            <translation>Kein Fehler nach dieser Stelle.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>No error before this position.</source>
            <translation>Kein Fehler vor dieser Stelle.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>No expression</source>
            <translation>Kein Ausdruck</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_view.py" />
            <source>no f0</source>
            <translation>keine f0</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_painter.py" />
            <source>No file</source>
            <translation>Keine Datei</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/score.py" />
            <source>No file is open.</source>
            <translation>Keine Datei ist offen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_model.py" />
            <source>No frequency range separates these two phonemes. Record more takes of them, or choose another pair.</source>
            <translation>Kein Frequenzbereich trennt diese beiden Phoneme. Mehr Takes von ihnen aufnehmen oder ein anderes Paar wählen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>No improvement found</source>
            <translation>Keine Verbesserung gefunden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>No label is selected. Click one below the sonagram first.</source>
            <translation>Keine Beschriftung ausgewählt. Zuerst eine unter dem Sonagramm anklicken.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/rule_dialogs.py" />
            <source>No labelled recording with this variable is loaded. With labels, the best limit is proposed here, with its gain.</source>
            <translation>Keine beschriftete Aufnahme mit dieser Variable geladen. Mit Beschriftungen stehen hier die beste Grenze und ihr Gewinn.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/score.py" />
            <source>No labelled sound is loaded.</source>
            <translation>Kein beschrifteter Ton ist geladen.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/scores/corpus.py" />
            <source>no labelled sound was found here</source>
            <translation>Hier wurde keine Audiodatei mit Beschriftungen gefunden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/score.py" />
            <source>No labels yet.</source>
            <translation>Keine Beschriftungen.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/stream.py" />
            <source>no microphone was found; connect one, or check that the audio system is running</source>
            <translation>kein Mikrofon gefunden; eines anschließen oder prüfen, ob das Audiosystem läuft</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/preset_choice.py" />
            <source>no model is installed: download it, or choose the folder of one that you have</source>
            <translation>es ist kein Modell installiert: herunterladen oder den Ordner eines vorhandenen wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>No network</source>
            <translation>Kein Netz</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>No network is open, so phonemes move the mouth; open one at Face network.</source>
            <translation>Kein Netz ist geöffnet, daher steuern Phoneme den Mund; bei „Gesichtsnetz“ eines öffnen.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/expression/felt.py" />
            <source>no part of a face called {name} follows a feeling; {parts}</source>
            <translation>kein Teil eines Gesichts namens {name} folgt einem Gefühl; {parts}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/rule_dialogs.py" />
            <source>No phoneme changes. Choose a rule that the variable is to narrow, or another limit.</source>
            <translation>Kein Phonem ändert sich. Eine Regel wählen, die die Variable eingrenzen soll, oder eine andere Grenze.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/fits/templates.py" />
            <source>no phoneme has enough speech for a template; record takes of 1 s each</source>
            <translation>für kein Phonem reicht die Sprache für ein Template; Takes von je 1 s aufnehmen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/style_fit.py" />
            <source>no recording has both speech and a mouth that moves; choose others</source>
            <translation>Keine Aufnahme hat sowohl Sprache als auch einen bewegten Mund; andere wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>no recording of the network has a {place} sound, so lips may stay apart there</source>
            <translation>keine Aufnahme des Netzes enthält einen Laut der Art {place}; dort bleiben die Lippen womöglich offen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/model.py" />
            <source>No shipped mouth table fits the blend shapes of this face ({names} …); write a mouth table for them and load it.</source>
            <translation>Keine mitgelieferte Mundtabelle passt zu den Blendshapes dieses Gesichts ({names} …); eine Mundtabelle dafür schreiben und laden.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/phoneme_view.py" />
            <source>No signal</source>
            <translation>Kein Signal</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>no signal from {microphone}</source>
            <translation>kein Signal von {microphone}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>no signal from {microphone} for {seconds} s; trying again every 2 s</source>
            <translation>seit {seconds} s kein Signal von {microphone}; neuer Versuch alle 2 s</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>No sound was recorded: the loudest part is at {db} dBFS. Check that the microphone is on and say it again, louder or closer.</source>
            <translation>Es wurde kein Laut aufgenommen: Die lauteste Stelle liegt bei {db} dBFS. Prüfen, ob das Mikrofon eingeschaltet ist, und noch einmal sprechen, lauter oder näher.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>No space left on device</source>
            <translation>Kein Platz auf dem Laufwerk</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>No style</source>
            <translation>Kein Stil</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>No such file or directory</source>
            <translation>Datei oder Ordner nicht gefunden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>No table is open, so phonemes move the mouth; open one at Recorded faces.</source>
            <translation>Keine Tabelle ist geöffnet, daher steuern Phoneme den Mund; bei „Aufgezeichnete Gesichter“ eine öffnen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/scripts.py" />
            <source>No table of recorded faces is open that could speak; open one, or choose a voice.</source>
            <translation>Keine Tabelle aufgezeichneter Gesichter ist offen, die sprechen könnte; eine öffnen oder eine Stimme wählen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/model.py" />
            <source>No take of {phoneme} was recorded: {state}. Try again once the microphone is running.</source>
            <translation>Kein Take von {phoneme} aufgenommen: {state}. Noch einmal versuchen, sobald das Mikrofon läuft.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>No takes or recordings loaded</source>
            <translation>Keine Takes oder Aufnahmen geladen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/take_list.py" />
            <source>No takes yet</source>
            <translation>Noch keine Takes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/exports.py" />
            <source>no text or TextGrid beside the file</source>
            <translation>kein Text oder TextGrid neben der Datei</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/score.py" />
            <source>No tier of the labels names phonemes only. Choose another one with Labels &gt; Tiers.</source>
            <translation>Keine Ebene der Beschriftung nennt nur Phoneme. Mit Beschriftungen &gt; Ebenen eine andere wählen.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_writing.py" />
            <source>no vertex moves, so there is nothing to show; name its mesh with --mesh</source>
            <translation>Kein Eckpunkt bewegt sich, daher gibt es nichts zu zeigen; Mesh mit --mesh angeben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/espeak.py" />
            <source>no voice is installed: espeak-ng is missing; pip install 'phonemeanalyser[speech]', or install libespeak-ng1 of your system</source>
            <translation>Keine Sprechstimme installiert, denn espeak-ng fehlt; pip install 'phonemeanalyser[speech]' ausführen oder das Systempaket libespeak-ng1 installieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/espeak.py" />
            <source>no voice speaks the language {tag}; choose one of {some} ({known} are known)</source>
            <translation>Keine Sprechstimme spricht die Sprache {tag}; eine wählen aus {some} ({known} sind bekannt)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>No voice was detected above the background noise. Speak louder or move closer to the microphone.</source>
            <translation>Über dem Hintergrundgeräusch wurde keine Stimme erkannt. Lauter oder näher am Mikrofon sprechen.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/storage/files.py" />
            <source>no Word document</source>
            <translation>kein Word-Dokument</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/sound_words.py" />
            <source>No word is selected. Click one in the timeline first.</source>
            <translation>Kein Wort ausgewählt. Zuerst eines in der Zeitleiste anklicken.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/sound_words.py" />
            <source>No words are known of this sound. Align its text first.</source>
            <translation>Von dieser Audiodatei sind keine Wörter bekannt. Zuerst ihren Text ausrichten.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf.py" />
            <source>node {place} of its scene is below two others; export it again</source>
            <translation>Knoten {place} der Szene liegt unter zwei anderen; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Nogai</source>
            <translation>Nogaisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>None</source>
            <translation>Keine</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>none</source>
            <translation>keins</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>None loaded</source>
            <translation>Keine geladen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>normal</source>
            <translation>Normale</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Normalise</source>
            <translation>Normieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Normalise to 100 %</source>
            <translation>Auf 100 % normieren</translation>
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
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>Not a directory</source>
            <translation>Ist kein Ordner</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>not listening</source>
            <translation>nicht aktiv</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_painter.py" />
            <source>Not measured in this sound</source>
            <translation>In dieser Aufnahme nicht gemessen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_painter.py" />
            <source>Not measured yet</source>
            <translation>Noch nicht gemessen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>Not measured yet: open a file, or play something.</source>
            <translation>Noch nichts gemessen: Datei öffnen oder etwas abspielen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>not noticeable</source>
            <translation>unmerklich</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/keys/key_panel.py" />
            <source>not saved</source>
            <translation>nicht gespeichert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>not silent</source>
            <translation>nicht still</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>Not spoken in the recording: {words} and {n} more words.</source>
            <translation>In der Aufnahme nicht gesprochen: {words} und {n} weitere Wörter.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>Not spoken in the recording: {words}.</source>
            <translation>In der Aufnahme nicht gesprochen: {words}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/sources.py" />
            <source>not spoken yet</source>
            <translation>noch nicht gesprochen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>Not used by “{name}”: {which}</source>
            <translation>Nicht genutzt von „{name}“: {which}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/preset_dialogs.py" />
            <source>Notes on the preset {preset}:</source>
            <translation>Notizen zum Preset {preset}:</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>nothing</source>
            <translation>nichts</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/osc.py" />
            <source>nothing can be received on {host}:{port} ({error}); choose another port</source>
            <translation>Auf {host}:{port} lässt sich nichts empfangen ({error}); anderen Port wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/score.py" />
            <source>Nothing in view is labelled.</source>
            <translation>Der sichtbare Teil ist nicht beschriftet.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>Nothing is selected. Shift+drag over the file to select a segment.</source>
            <translation>Nichts ist ausgewählt. Mit Umschalt über die Datei ziehen, um einen Abschnitt auszuwählen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/selection.py" />
            <source>Nothing is selected. Shift+drag over the file, or press [ and ] at the cursor, then try again.</source>
            <translation>Nichts ist ausgewählt. Mit Umschalt+Ziehen oder mit [ und ] am Cursor einen Abschnitt der Datei auswählen und noch einmal versuchen.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/textgrid.py" />
            <source>nothing more</source>
            <translation>nichts weiter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>nothing that is loaded is clearly labelled {phonemes}; load recordings that have it</source>
            <translation>Nichts Geladenes ist eindeutig als {phonemes} beschriftet; Aufnahmen laden, die es enthalten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>Nothing was recorded, since the microphone sent no signal. Check the microphone.</source>
            <translation>Es wurde nichts aufgenommen, da das Mikrofon kein Signal lieferte. Das Mikrofon prüfen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>noticeable</source>
            <translation>merklich</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_tree.py" />
            <source>Now</source>
            <translation>Jetzt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Now read this test sentence</source>
            <translation>Jetzt diesen Testsatz vorlesen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/shipping/targets.py" />
            <source>npm cannot fetch {words}; connect to the network, {otherwise}</source>
            <translation>npm kann {words} nicht laden; mit dem Netzwerk verbinden, {otherwise}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/shipping/targets.py" />
            <source>npm fetched another {name} than the page was made for; clear its cache, {otherwise}</source>
            <translation>npm hat ein anderes {name} geladen, als die Seite braucht; seinen Cache leeren, {otherwise}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/phoneme_data_panel.py" />
            <source>Number</source>
            <translation>Zahl</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/rule_dialogs.py" />
            <source>Number of the new rule: earlier rules decide first</source>
            <translation>Nummer der neuen Regel: frühere Regeln entscheiden zuerst</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/phoneme_data_panel.py" />
            <source>Numbers of a File…</source>
            <translation>Zahlen einer Datei…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/phoneme_data_panel.py" />
            <source>Numbers to edit: those of the preset, or those of a set for a range of pitch</source>
            <translation>Zu bearbeitende Zahlen: die des Presets oder die eines Satzes für einen Grundfrequenzbereich</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/score_strip.py" />
            <source>of 1 speaker</source>
            <translation>von 1 Sprecher</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/score_strip.py" />
            <source>of {n} speakers</source>
            <translation>von {n} Sprechern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_model.py" />
            <source>Off</source>
            <translation>Aus</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/preset_choice.py" />
            <source>Offline</source>
            <translation>Offline</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>offline, ±{seconds} s of context</source>
            <translation>Offline, ±{seconds} s Kontext</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Old preset</source>
            <translation>Altes Preset</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>On a {left_out} that was held out they are worse than the current preset. Load more data.</source>
            <translation>An zurückgehaltenen Daten ({left_out}) gemessen sind sie schlechter als das aktuelle Preset. Mehr Daten laden.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>One curve for each phoneme</source>
            <translation>Eine Kurve je Phonem</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>One curve for each phoneme of each speaker</source>
            <translation>Eine Kurve je Phonem und Sprecher</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>One curve for each speaker</source>
            <translation>Eine Kurve je Sprecher</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/files.py" />
            <source>one of 1 to {n}, or the mix</source>
            <translation>einen von 1 bis {n} oder die Mischung</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/conversion/speech_files.py" />
            <source>one of them can be printed, and several are asked for with -; name files for the others</source>
            <translation>Nur eine Datei lässt sich ausgeben, mit - sind mehrere verlangt; Dateinamen für die anderen angeben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/storage/strict_table.py" />
            <source>one of {names}</source>
            <translation>eins von {names}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/table.py" />
            <source>one of {names}, or a list of at most {most_movestates} names</source>
            <translation>eins von {names} oder eine Liste von höchstens {most_movestates} Namen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>one sentence</source>
            <translation>ein Satz</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>one single sound</source>
            <translation>ein einzelner Laut</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>One step; with Shift, a tenth</source>
            <translation>Ein Schritt; mit Umschalt ein Zehntel</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/choice.py" />
            <source>one table moves a face, and there are {names}; name one of them with --use, or a person with --person and the language of the text with --language</source>
            <translation>Eine Tabelle bewegt ein Gesicht, und es gibt {names}; eine davon mit --use nennen, oder eine Person mit --person und die Sprache des Textes mit --language</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/files.py" />
            <source>only one channel</source>
            <translation>nur einen Kanal</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/live/loopback.py" />
            <source>only {caught} of {n_clicks} clicks were recorded; turn the loudspeaker up, or move the microphone</source>
            <translation>Nur {caught} von {n_clicks} Klicks wurden aufgenommen; Lautsprecher lauter stellen oder Mikrofon näher rücken</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Only {letter} correct</source>
            <translation>Nur {letter} richtig</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Only {letter} correct: {seconds:.1f} s</source>
            <translation>Nur {letter} richtig: {seconds:.1f} s</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Onset and release of speech</source>
            <translation>Ein- und Ausblenden durch Sprache</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Open</source>
            <translation>Öffnen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/difference_model.py" />
            <source>Open a recording or speak a text to see where both heads differ</source>
            <translation>Eine Aufnahme öffnen oder einen Text sprechen lassen, um zu sehen, wo sich die Köpfe unterscheiden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/keys/key_lanes.py" />
            <source>Open a recording to edit its keys</source>
            <translation>Eine Aufnahme öffnen, um ihre Keyframes zu bearbeiten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/time_line.py" />
            <source>Open a recording with Ctrl+O, or write a text above and press Speak</source>
            <translation>Mit Strg+O eine Aufnahme öffnen oder oben einen Text schreiben und „Vorlesen“ drücken</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/welcome.py" />
            <source>Open a recording, paste its text, align both, and export the animation of a face.</source>
            <translation>Eine Aufnahme öffnen, ihren Text einfügen, beides aneinander ausrichten und die Animation eines Gesichts exportieren.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Open an audio file (Ctrl+O)</source>
            <translation>Audiodatei öffnen (Strg+O)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Open and closed</source>
            <translation>Offen und geschlossen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Open Audio File</source>
            <translation>Audiodatei öffnen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Open Audio File…</source>
            <translation>Audiodatei öffnen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Open Face Network</source>
            <translation>Gesichtsnetz öffnen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Open Face Network…</source>
            <translation>Gesichtsnetz öffnen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/preset_picker.py" />
            <source>Open File…</source>
            <translation>Datei öffnen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/preset_dialogs.py" />
            <source>Open Folder</source>
            <translation>Ordner öffnen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/headers.py" />
            <source>open it in an audio editor and export it again</source>
            <translation>in einem Audioeditor öffnen und neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Open Network…</source>
            <translation>Netz öffnen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/sources.py" />
            <source>open one with Ctrl+O</source>
            <translation>mit Strg+O öffnen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Open Recent</source>
            <translation>Zuletzt geöffnet</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Open Recorded Faces…</source>
            <translation>Aufgezeichnete Gesichter öffnen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Open Script</source>
            <translation>Skript öffnen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Open Script…</source>
            <translation>Skript öffnen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Open Table of Recorded Faces</source>
            <translation>Tabelle aufgezeichneter Gesichter öffnen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Open Table…</source>
            <translation>Tabelle öffnen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Open the text of the recording: a text file, a TextGrid, or JSON with word times</source>
            <translation>Den Text der Aufnahme öffnen: Textdatei, TextGrid oder JSON mit Wortzeiten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/session.py" />
            <source>opening</source>
            <translation>dem Öffnen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/driver_model.py" />
            <source>Opening face network…</source>
            <translation>Gesichtsnetz wird geöffnet …</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/performance_model.py" />
            <source>Opening table…</source>
            <translation>Tabelle wird geöffnet …</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>opening the microphone</source>
            <translation>Mikrofon wird geöffnet</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/preset_choice.py" />
            <source>Opening the model…</source>
            <translation>Modell wird geöffnet…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_model.py" />
            <source>Opening…</source>
            <translation>Wird geöffnet …</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Opening… {percent:.0f} %</source>
            <translation>Öffnen… {percent:.0f} %</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Opens the mouth less and later, and closes it for a shorter time</source>
            <translation>Öffnet den Mund weniger und später und schließt ihn kürzer</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Opens the mouth wider and faster, and moves the head more</source>
            <translation>Öffnet den Mund weiter und schneller und bewegt den Kopf mehr</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/shipping/targets.py" />
            <source>or ship the target web-module, which has no page</source>
            <translation>oder das Ziel web-module wählen, das keine Seite hat</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Orbit; with Shift, pan</source>
            <translation>Umkreisen; mit Umschalt verschieben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/serve_dialog.py" />
            <source>Other computers, too (0.0.0.0)</source>
            <translation>Auch andere Rechner (0.0.0.0)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Other sounds</source>
            <translation>Andere Laute</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_tree.py" />
            <source>otherwise</source>
            <translation>sonst</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Output</source>
            <translation>Ausgabe</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Output device and speed</source>
            <translation>Ausgabegerät und Tempo</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/sonagram.py" />
            <source>Overlays</source>
            <translation>Überlagerungen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Overwrite</source>
            <translation>Überschreiben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/ship_dialog.py" />
            <source>Overwrite changed files</source>
            <translation>Geänderte Dateien überschreiben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Overwrite Existing Files</source>
            <translation>Vorhandene Dateien überschreiben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Own sound of the recorded faces</source>
            <translation>Eigener Ton der aufgezeichneten Gesichter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_model.py" />
            <source>own sound of the recorded faces</source>
            <translation>eigener Ton der aufgezeichneten Gesichter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Page</source>
            <translation>Seite</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Page Up, Page Down</source>
            <translation>Bild auf, Bild ab</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>part</source>
            <translation>Teil</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>Part of the recording</source>
            <translation>Teil der Aufnahme</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>Part of the recording whose phonemes are shown</source>
            <translation>Teil der Aufnahme, dessen Phoneme gezeigt werden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Parts of the page</source>
            <translation>Teile der Seite</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Paste the text of the recording here. Ctrl+O opens another recording.</source>
            <translation>Den Text der Aufnahme hier einfügen. Strg+O öffnet eine andere Aufnahme.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/takes/take.py" />
            <source>pauses must be a list of pairs of seconds, found {entry}; correct it</source>
            <translation>Pausen müssen eine Liste von Sekundenpaaren sein, gefunden {entry}; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Peak level from which the intensity is 1.</source>
            <translation>Spitzenpegel, ab dem die Intensität 1 ist.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/level_meter.py" />
            <source>Peak level of the microphone in dBFS, and the highest peak of the last 1.5 s. Raise the gain if it reads low, reduce it if it reads high. The light shows for one minute that the signal clipped</source>
            <translation>Spitzenpegel des Mikrofons in dBFS und der höchste der letzten 1.5 s. Verstärkung erhöhen, wenn „niedrig“ steht, verringern, wenn „hoch“ steht. Das Licht meldet eine Minute lang, dass das Signal übersteuert war</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Peak level up to which the intensity is 0.</source>
            <translation>Spitzenpegel, bis zu dem die Intensität 0 ist.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Peak levels at which the intensity is 0 and 1; in silence it is always 0.</source>
            <translation>Spitzenpegel, bei denen die Intensität 0 und 1 ist; bei Stille ist sie immer 0.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>peak {range}</source>
            <translation>Spitze {range}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>per window</source>
            <translation>je Fenster</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/page.py" />
            <source>Permanently remove the deleted take from disk? Earlier changes to takes can then no longer be undone.</source>
            <translation>Den gelöschten Take endgültig vom Datenträger entfernen? Frühere Änderungen an Takes lassen sich dann nicht mehr rückgängig machen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/page.py" />
            <source>Permanently remove {n} deleted takes from disk? Earlier changes to takes can then no longer be undone.</source>
            <translation>{n} gelöschte Takes endgültig vom Datenträger entfernen? Frühere Änderungen an Takes lassen sich dann nicht mehr rückgängig machen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>Permission denied</source>
            <translation>Zugriff verweigert</translation>
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
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_editor.py" />
            <source>Phoneme</source>
            <translation>Phonem</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/phoneme_view.py" />
            <source>Phoneme changes per second, over the last 3 seconds; speech has about 9. A preset with more smoothing, such as thesis-calm, changes less often</source>
            <translation>Phonemwechsel pro Sekunde in den letzten 3 Sekunden; Sprache hat etwa 9. Ein Preset mit mehr Glättung wie thesis-calm wechselt seltener</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/page.py" />
            <source>Phoneme for {name}</source>
            <translation>Phonem für {name}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Phoneme of the selected take; choose another to relabel it</source>
            <translation>Phonem des ausgewählten Takes; ein anderes wählen, um ihn umzubenennen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Phoneme of the take</source>
            <translation>Phonem des Takes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/phoneme_view.py" />
            <source>Phoneme recognised in the current frame</source>
            <translation>Im aktuellen Frame erkanntes Phonem</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/take_list.py" />
            <source>Phoneme that the take holds</source>
            <translation>Phonem, das der Take enthält</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>Phoneme to separate</source>
            <translation>Phonem, das getrennt werden soll</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>Phoneme to separate it from</source>
            <translation>Phonem, von dem es getrennt wird</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/variables_panel.py" />
            <source>Phoneme to separate it from, or all others</source>
            <translation>Phonem, von dem es getrennt werden soll, oder alle anderen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/encoder/model_folder.py" />
            <source>phonemeanalyser whisper --fetch gets it (145 MB), --folder names one that you have, and the packages {name} bring it</source>
            <translation>phonemeanalyser whisper --fetch lädt es (145 MB), --folder nennt ein vorhandenes, und die Pakete {name} enthalten es</translation>
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
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>Phonemes</source>
            <translation>Phoneme</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Phonemes (rules)</source>
            <translation>Phoneme (Regeln)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>phonemes as a Praat TextGrid</source>
            <translation>Phoneme als Praat-TextGrid</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>phonemes as a table</source>
            <translation>Phoneme als Tabelle</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>phonemes as Audacity labels</source>
            <translation>Phoneme als Audacity-Textmarken</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>phonemes as JSON</source>
            <translation>Phoneme als JSON</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>Phonemes as recognised</source>
            <translation>Phoneme wie erkannt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>Phonemes of the labels</source>
            <translation>Phoneme der Beschriftung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/session.py" />
            <source>Phonemes of {name} saved as {target}. Model: {model}.</source>
            <translation>Phoneme von {name} gespeichert als {target}. Modell: {model}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_layout.py" />
            <source>Phones</source>
            <translation>Phone</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/rendering/renderer.py" />
            <source>pictures need OpenGL 3.3, in software at least, and there is none ({error}); install a graphics driver, on Linux the packages libegl1 and libgl1-mesa-dri</source>
            <translation>Für Bilder wird OpenGL 3.3 benötigt, zumindest in Software, und es fehlt ({error}); Grafiktreiber installieren, unter Linux die Pakete libegl1 und libgl1-mesa-dri</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/rendering/renderer.py" />
            <source>pictures of {size}x{size_2} pixels are too large for OpenGL here; make them smaller</source>
            <translation>Bilder von {size}x{size_2} Pixeln sind für OpenGL hier zu groß; kleiner wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Pictures per Second</source>
            <translation>Bilder pro Sekunde</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Pictures per second of the animation; Left and Right in the timeline go one picture back or forward</source>
            <translation>Bilder pro Sekunde der Animation; Links und Rechts in der Zeitleiste gehen ein Bild zurück oder weiter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>pink noise</source>
            <translation>rosa Rauschen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Pinyin letters</source>
            <translation>Pinyin-Buchstaben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/driver_model.py" />
            <source>Pinyin letters cannot drive the mouth, since no Chinese is spoken; choose another driver.</source>
            <translation>Pinyin-Buchstaben können den Mund nicht steuern, da kein Chinesisch gesprochen wird; eine andere Steuerung wählen.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/presets/model_choice.py" />
            <source>pip install "phonemeanalyser[whisper]" installs a more accurate one</source>
            <translation>pip install "phonemeanalyser[whisper]" installiert ein genaueres</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/sonagram.py" />
            <source>Pitch (blue line, 0 to 500 Hz from bottom to top)</source>
            <translation>Grundfrequenz (blaue Linie, 0 bis 500 Hz von unten nach oben)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>pitch (f0)</source>
            <translation>Tonhöhe (f0)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/rule_dialogs.py" />
            <source>Place</source>
            <translation>Platz</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>plain</source>
            <translation>einfach</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Plain lets high frequencies alias, as in the thesis; anti-aliased filters them out first.</source>
            <translation>Einfach erzeugt Aliasing wie in der Thesis; ohne Aliasing filtert hohe Frequenzen zuvor heraus.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Play</source>
            <translation>Abspielen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/welcome.py" />
            <source>Play a recording and see which phonemes are recognised, and why.</source>
            <translation>Eine Aufnahme abspielen und sehen, welche Phoneme erkannt werden und warum.</translation>
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
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Play take</source>
            <translation>Take abspielen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Play the sentence; the head shows the mouth shapes of the new preset</source>
            <translation>Satz abspielen; der Kopf zeigt die Mundformen des neuen Presets</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Play the sentence; the head shows the mouth shapes of the old preset</source>
            <translation>Satz abspielen; der Kopf zeigt die Mundformen des alten Presets</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Play the trimmed part of the take (Return or double-click)</source>
            <translation>Zugeschnittenen Teil des Takes abspielen (Eingabetaste oder Doppelklick)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Play/Pause</source>
            <translation>Wiedergabe/Pause</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Playback volume in dB; click to choose output device and speed</source>
            <translation>Wiedergabelautstärke in dB; Klick: Ausgabegerät und Tempo wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Playback volume {volume:.0f} dB</source>
            <translation>Wiedergabelautstärke {volume:.0f} dB</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/feeling_lane.py" />
            <source>Pleasantness</source>
            <translation>Angenehmheit</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>PNG image (*.png);;SVG drawing (*.svg)</source>
            <translation>PNG-Bild (*.png);;SVG-Grafik (*.svg)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Polish</source>
            <translation>Polnisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/serve_dialog.py" />
            <source>Port</source>
            <translation>Port</translation>
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
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Poses and numbers of the style</source>
            <translation>Posen und Zahlen des Stils</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Poses of the lips</source>
            <translation>Posen der Lippen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Poses of the tongue</source>
            <translation>Posen der Zunge</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Poses over recorded faces</source>
            <translation>Posen über aufgezeichneten Gesichtern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Position and duration, in minutes and seconds</source>
            <translation>Position und Dauer in Minuten und Sekunden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Praat TextGrid</source>
            <translation>Praat TextGrid</translation>
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
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/preset_choice.py" />
            <source>Preset</source>
            <translation>Preset</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/ship_dialog.py" />
            <source>Preset as a C array, too (preset.c)</source>
            <translation>Preset auch als C-Array (preset.c)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/preset_dialogs.py" />
            <source>Preset Notes</source>
            <translation>Notizen zum Preset</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Preset Notes…</source>
            <translation>Notizen zum Preset…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Preset that recognises the phonemes</source>
            <translation>Preset, das die Phoneme erkennt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Preset to compare</source>
            <translation>Preset zum Vergleich</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Preset to compare with the one in use</source>
            <translation>Preset, mit dem das verwendete verglichen wird</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/score_strip.py" />
            <source>Preset: {preset}{changed}</source>
            <translation>Preset: {preset}{changed}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/preset_picker.py" />
            <source>Presets</source>
            <translation>Presets</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/preset_picker.py" />
            <source>Presets ({endings})</source>
            <translation>Presets ({endings})</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Press Preview to see the output for the selected file, or for the first one.</source>
            <translation>„Vorschau“ zeigt die Ausgabe für die ausgewählte oder die erste Datei.</translation>
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
            <location filename="../../../phonemeanalyser/desktop/session/sources.py" />
            <source>Press Space to play the tone</source>
            <translation>Leertaste drücken, um den Ton abzuspielen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Preview</source>
            <translation>Vorschau</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Preview of the output</source>
            <translation>Vorschau der Ausgabe</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Previous Error</source>
            <translation>Vorheriger Fehler</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Previous Label</source>
            <translation>Vorherige Beschriftung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Previous Panel</source>
            <translation>Vorheriger Bereich</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Previous Picture (Left)</source>
            <translation>Voriges Bild (Links)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Previous Poor Match</source>
            <translation>Voriges schlecht passendes Wort</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Previous, next key; with Ctrl, curve</source>
            <translation>Voriger, nächster Keyframe; mit Strg Kurve</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Priority</source>
            <translation>Priorität</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>probability of {phoneme}</source>
            <translation>Wahrscheinlichkeit von {phoneme}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>programs without Python recognise with the preset's small network; the real-time model with the encoder needs Python and onnxruntime</source>
            <translation>Programme ohne Python erkennen mit dem kleinen Netz des Presets; das Echtzeitmodell mit dem Encoder braucht Python und onnxruntime</translation>
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
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>quantise must be one of 1, 2, 4, got {quantise}; choose one of them</source>
            <translation>Die Quantisierung muss 1, 2 oder 4 sein, gefunden {quantise}; eine davon wählen</translation>
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
            <location filename="../../../phonemeanalyser/desktop/talk/keys/key_lanes.py" />
            <source>raise keys</source>
            <translation>Keyframes anheben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/keys/key_lanes.py" />
            <source>Raise Range by 0.1</source>
            <translation>Bereich um 0.1 anheben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Raise, lower key; with Shift, farther</source>
            <translation>Keyframe anheben, senken; mit Umschalt weiter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Random</source>
            <translation>Zufällig</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Random seed</source>
            <translation>Startwert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Random variation</source>
            <translation>Zufällige Variation</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Random within 15 % of the duration</source>
            <translation>Zufällig, Dauer auf 15 % genau</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Range</source>
            <translation>Bereich</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Rate</source>
            <translation>Rate</translation>
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
            <source>Read aloud</source>
            <translation>Vorlesen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Read aloud in your normal voice</source>
            <translation>Mit normaler Stimme vorlesen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Read names of speakers, [directions], *emphasis*, &lt;tags&gt; and &amp;entities; in a script as words; otherwise they are left out</source>
            <translation>Sprechernamen, [Regieanweisungen], *Betonung*, &lt;tags&gt; und &amp;Entitäten; in einem Skript als Wörter lesen; sonst werden sie ausgelassen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Read Notation Literally</source>
            <translation>Notation wörtlich lesen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/welcome.py" />
            <source>Read two sentences aloud; the preset is adapted to your voice in a minute.</source>
            <translation>Zwei Sätze vorlesen; in einer Minute ist das Preset an die Stimme angepasst.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>Read-only file system</source>
            <translation>Laufwerk ist schreibgeschützt</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/storage/files.py" />
            <source>reading it is not permitted; change its permissions or copy it</source>
            <translation>Lesen ist nicht erlaubt; die Rechte ändern oder die Datei kopieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Ready?</source>
            <translation>Bereit?</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/preset_choice.py" />
            <source>Real-time</source>
            <translation>Echtzeit</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/preset_choice.py" />
            <source>Real-time model</source>
            <translation>Echtzeitmodell</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Realign This Word</source>
            <translation>Dieses Wort neu ausrichten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Receive OSC at</source>
            <translation>OSC empfangen an</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_model.py" />
            <source>Receiver not reached</source>
            <translation>Empfänger nicht erreicht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Receiver of the OSC messages</source>
            <translation>Empfänger der OSC-Nachrichten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_model.py" />
            <source>Receiving {name}</source>
            <translation>Empfängt {name}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_model.py" />
            <source>Receiving {name} and {n} more</source>
            <translation>Empfängt {name} und {n} weitere</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/preset_dialogs.py" />
            <source>Recent</source>
            <translation>Zuletzt verwendet</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/serve_dialog.py" />
            <source>Recognise speech for other programs</source>
            <translation>Sprache für andere Programme erkennen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_editor.py" />
            <source>Recognise with Extended rules; undo brings the preset back</source>
            <translation>Mit Extended rules erkennen; Rückgängig bringt das Preset zurück</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>Recognise with these rules; Ctrl+Z restores the preset</source>
            <translation>Mit diesen Regeln erkennen; Strg+Z stellt das Preset wieder her</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/confusion_view.py" />
            <source>Recognised</source>
            <translation>Erkannt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/confusion_view.py" />
            <source>Recognised as →</source>
            <translation>Erkannt als →</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Recognised with the preset {preset}. Pitch and formants: of the voiced frames. Level: root mean square (mean) and largest sample (max), dBFS. Phonemes: shares of all frames.</source>
            <translation>Erkannt mit dem Preset {preset}. Grundfrequenz und Formanten: der stimmhaften Frames. Pegel: Effektivwert (Mittel) und größter Abtastwert (Max), dBFS. Phoneme: Anteile an allen Frames.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/preset_choice.py" />
            <source>Recognisers of other packages</source>
            <translation>Erkenner anderer Pakete</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/session.py" />
            <source>Recognising the phonemes of {name} and saving them as {target}…</source>
            <translation>Phoneme von {name} werden erkannt und als {target} gespeichert…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Recognition only</source>
            <translation>Nur Erkennung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Record</source>
            <translation>Aufnehmen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Record a take of {name}</source>
            <translation>Take von {name} aufnehmen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Record from the microphone to {folder} (R)</source>
            <translation>Vom Mikrofon nach {folder} aufnehmen (R)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Record take while held</source>
            <translation>Take aufnehmen, solange gehalten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/score_strip.py" />
            <source>Record Takes</source>
            <translation>Takes aufnehmen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_model.py" />
            <source>Record takes or load labelled recordings first.</source>
            <translation>Zuerst Takes aufnehmen oder beschriftete Aufnahmen laden.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>Record takes or load labelled recordings to see distributions</source>
            <translation>Takes aufnehmen oder Aufnahmen laden, um Verteilungen zu sehen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>record to another disk</source>
            <translation>auf ein anderes Laufwerk aufnehmen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Recorded faces</source>
            <translation>Aufgezeichnete Gesichter</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/conversion/driving.py" />
            <source>recorded faces are looked up by the phones that are said</source>
            <translation>Gesichtsaufnahmen werden anhand der gesprochenen Laute nachgeschlagen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/driver_model.py" />
            <source>Recorded faces are looked up while a text is spoken; press Speak to apply them to this text.</source>
            <translation>Aufgezeichnete Gesichter werden beim Vorlesen nachgeschlagen; noch einmal auf „Vorlesen“ drücken, um sie auf diesen Text anzuwenden.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Recorded {seconds:.1f} s to {path}</source>
            <translation>{seconds:.1f} s aufgenommen in {path}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/figures_table.py" />
            <source>Recording</source>
            <translation>Aufnahme</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>Recording did not start, since the latency is being measured. Try again in a few seconds.</source>
            <translation>Die Aufnahme begann nicht, da gerade die Latenz gemessen wird. In einigen Sekunden noch einmal versuchen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>Recordings</source>
            <translation>Aufnahmen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Recordings Folder</source>
            <translation>Aufnahmeordner</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Recordings Folder…</source>
            <translation>Aufnahmeordner…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>Recordings: {n} ({minutes:.1f} min)</source>
            <translation>Aufnahmen: {n} ({minutes:.1f} min)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>Recordings: {n} ({seconds:.1f} s)</source>
            <translation>Aufnahmen: {n} ({seconds:.1f} s)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Rectangle</source>
            <translation>Rechteck</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Reduced by speech</source>
            <translation>Durch Sprache reduziert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Reduction</source>
            <translation>Minderung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Reduction of expressions by speech</source>
            <translation>Minderung des Ausdrucks durch Sprache</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>relabel {take}</source>
            <translation>Umbenennen von {take}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Release</source>
            <translation>Release</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Release time</source>
            <translation>Release-Zeit</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>Remove</source>
            <translation>Entfernen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/curves.py" />
            <source>remove averaged spectra</source>
            <translation>Gemittelte Spektren entfernen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/page.py" />
            <source>Remove Deleted Takes</source>
            <translation>Gelöschte Takes entfernen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Remove Deleted Takes…</source>
            <translation>Gelöschte Takes entfernen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>remove it, or use one of {names}</source>
            <translation>entfernen oder einen davon verwenden: {names}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Remove Lexicon</source>
            <translation>Lexikon entfernen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/phoneme_data_model.py" />
            <source>remove pitch set</source>
            <translation>Grundfrequenz-Satz entfernen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/phoneme_data_panel.py" />
            <source>Remove Set</source>
            <translation>Satz entfernen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Remove the face capture {path}</source>
            <translation>Gesichtsaufzeichnung {path} entfernen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Remove the lexicon {path}</source>
            <translation>Lexikon {path} entfernen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/phoneme_data_panel.py" />
            <source>Remove this pitch set; Ctrl+Z restores it</source>
            <translation>Diesen Grundfrequenz-Satz entfernen; Strg+Z stellt ihn wieder her</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Remove Variable</source>
            <translation>Variable entfernen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Remove Variable…</source>
            <translation>Variable entfernen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>Remove what is selected (Delete); undo restores it</source>
            <translation>Ausgewählte entfernen (Entf); Rückgängig stellt sie wieder her</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>remove {name}</source>
            <translation>{name} entfernen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Removes frequencies below the start (hum, rumble) and fades in up to the end.</source>
            <translation>Entfernt Frequenzen unter dem Anfang (Brummen, Rumpeln) und blendet bis zum Ende ein.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>Rename</source>
            <translation>Umbenennen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Rename Label</source>
            <translation>Beschriftung umbenennen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/label_tiers.py" />
            <source>rename label</source>
            <translation>Beschriftung umbenennen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Rename Style</source>
            <translation>Stil umbenennen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Rename Word or Phone (F2)</source>
            <translation>Wort oder Phon umbenennen (F2)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Rename…</source>
            <translation>Umbenennen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/sound_words.py" />
            <source>renaming of a phone</source>
            <translation>Umbenennen eines Phons</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/sound_words.py" />
            <source>renaming of a word</source>
            <translation>Umbenennen eines Wortes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Repeat</source>
            <translation>Wiederholen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Repeat previous sound</source>
            <translation>Vorigen Laut wiederholen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Repeat the previous step (Backspace)</source>
            <translation>Vorigen Schritt wiederholen (Rücktaste)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Repeat this sound</source>
            <translation>Diesen Laut wiederholen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Repeat this step (R)</source>
            <translation>Diesen Schritt wiederholen (R)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Rescan Audio Devices</source>
            <translation>Audiogeräte neu suchen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Rescan audio devices</source>
            <translation>Audiogeräte neu suchen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Rescan audio devices (F5)</source>
            <translation>Audiogeräte neu suchen (F5)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/threshold_view.py" />
            <source>Reset</source>
            <translation>Zurücksetzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/keys/key_lanes.py" />
            <source>reset keys</source>
            <translation>Keyframes zurücksetzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Reset Layout</source>
            <translation>Layout zurücksetzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/keys/key_lanes.py" />
            <source>Reset Range</source>
            <translation>Bereich zurücksetzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Reset to Speech</source>
            <translation>Zurücksetzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/threshold_view.py" />
            <source>Reset to the value in the preset file</source>
            <translation>Auf den Wert der Preset-Datei zurücksetzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/plot.py" />
            <source>Reset Zoom</source>
            <translation>Zoom zurücksetzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>Reset {text}</source>
            <translation>{text} zurücksetzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>Reset {text} to the value in the preset file</source>
            <translation>{text} auf den Wert der Preset-Datei zurücksetzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>reset {what}</source>
            <translation>{what} zurücksetzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/unsaved.py" />
            <source>restore unsaved changes</source>
            <translation>ungespeicherte Änderungen wiederherstellen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>restore {take}</source>
            <translation>Wiederherstellen von {take}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Return</source>
            <translation>Eingabetaste</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_view.py" />
            <source>Return to the live signal of the microphone (Ctrl+B)</source>
            <translation>Zurück zum Live-Signal des Mikrofons (Strg+B)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Revert</source>
            <translation>Zurücksetzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>revert to the file</source>
            <translation>auf die Datei zurücksetzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Right</source>
            <translation>Rechts</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>right-half</source>
            <translation>rechte Hälfte</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/take_list.py" />
            <source>RMS level of the trimmed part in dBFS</source>
            <translation>Effektivpegel des zugeschnittenen Teils in dBFS</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Romanian</source>
            <translation>Rumänisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>Round-trip latency {ms:.0f} ms ({n_detected} of {n_played} clicks detected, spread {spread:.0f} ms). {share}</source>
            <translation>Latenz von Ausgang zu Eingang {ms:.0f} ms ({n_detected} von {n_played} Klicks erkannt, Streuung {spread:.0f} ms). {share}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>row {number}</source>
            <translation>Zeile {number}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/inspection/averaged_spectrum.py" />
            <source>row {number} must hold finite numbers of 0 or more, found {row}</source>
            <translation>Zeile {number} muss endliche Zahlen ab 0 enthalten, gefunden {row}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/inspection/averaged_spectrum.py" />
            <source>row {number} must hold {n_columns} numbers, found {row}</source>
            <translation>Zeile {number} muss {n_columns} Zahlen enthalten, gefunden: {row}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_tree.py" />
            <source>Rule</source>
            <translation>Regel</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_tree.py" />
            <source>Rules</source>
            <translation>Regeln</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>Rules found</source>
            <translation>Gefundene Regeln</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_model.py" />
            <source>rules from takes</source>
            <translation>Regeln aus Takes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_editor.py" />
            <source>Rules from Takes…</source>
            <translation>Regeln aus Takes…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>rules need labels of at least two sounds, and the recordings have only {only}; load some with others</source>
            <translation>Regeln brauchen Beschriftungen von mindestens zwei Lauten, die Aufnahmen haben nur {only}; welche mit anderen laden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Rules over frequency bands whose limits can all be dragged: mouth shapes {percent} % on left-out speakers.</source>
            <translation>Regeln über Frequenzbändern, deren Grenzen sich alle ziehen lassen: Mundformen {percent} % bei ausgelassenen Sprechern.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>Rules: {rules}, conditions: {conditions}.</source>
            <translation>Regeln: {rules}, Bedingungen: {conditions}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/exports.py" />
            <source>running</source>
            <translation>läuft</translation>
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
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>s</source>
            <translation>s</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>S and SH</source>
            <translation>S und SCH</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>S if both hold, SH if only the first</source>
            <translation>S, wenn beide gelten, SCH, wenn nur die erste</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Same as Talk</source>
            <translation>Wie unter Sprechen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Same as Talk: {name}</source>
            <translation>Wie unter Sprechen: {name}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_model.py" />
            <source>Same as the head</source>
            <translation>Wie der Kopf</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Sample rate</source>
            <translation>Abtastrate</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Sample rate of the microphone; best: 44 100 Hz, if the device supports it</source>
            <translation>Abtastrate des Mikrofons; beste: 44 100 Hz, falls das Gerät sie kann</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/resampling.py" />
            <source>samples are float32 within ±1, int16 or int32, got {dtype}; convert them</source>
            <translation>Samples sind float32 in ±1, int16 oder int32, gefunden {dtype}; umwandeln</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/resampling.py" />
            <source>samples have the shape (n,), or (n, n_channels) with at most {most_channels} channels, got {shape}; turn them, or mix them to one channel</source>
            <translation>Samples brauchen die Form (n,) oder (n, n_channels) mit höchstens {most_channels} Kanälen, gefunden {shape}; Achsen tauschen oder zu einem Kanal mischen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/resampling.py" />
            <source>samples lie within ±1, found {loudest}; give integers as int16 or int32, or divide them by 32768</source>
            <translation>Samples müssen in ±1 liegen, gefunden {loudest}; ganze Zahlen als int16 oder int32 übergeben oder durch 32768 teilen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>Save</source>
            <translation>Speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/preset_dialogs.py" />
            <source>Save 21 Numbers Only</source>
            <translation>Nur 21 Zahlen speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/preset_dialogs.py" />
            <source>Save as PhonemeData</source>
            <translation>Als PhonemeData speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/preset_dialogs.py" />
            <source>Save as TOML…</source>
            <translation>Als TOML speichern…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/preset_dialogs.py" />
            <source>Save As…</source>
            <translation>Speichern unter…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>Save Averaged Spectra</source>
            <translation>Gemittelte Spektren speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>Save Averaged Spectrum</source>
            <translation>Gemitteltes Spektrum speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/preset_dialogs.py" />
            <source>Save changes to the preset {preset}?</source>
            <translation>Änderungen am Preset {preset} speichern?</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>Save Curve…</source>
            <translation>Kurve speichern…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/keys/key_panel.py" />
            <source>Save Keys</source>
            <translation>Keyframes speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Save Labels</source>
            <translation>Beschriftungen speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Save Labels As…</source>
            <translation>Beschriftungen speichern unter…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Save Mouth Table</source>
            <translation>Mundtabelle speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/mapping_dialog.py" />
            <source>Save Mouth Table…</source>
            <translation>Mundtabelle speichern…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>Save or export what is selected in the table; all that is shown if nothing is</source>
            <translation>Ausgewählte Kurven speichern oder exportieren; ohne Auswahl alle angezeigten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Save Phonemes</source>
            <translation>Phoneme speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Save Phonemes with the Recording (.csv)</source>
            <translation>Phoneme zur Aufnahme speichern (.csv)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Save Phonemes…</source>
            <translation>Phoneme speichern…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Save Picture</source>
            <translation>Bild speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>Save Picture…</source>
            <translation>Bild speichern…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Save Preset</source>
            <translation>Preset speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/preset_dialogs.py" />
            <source>Save Preset As</source>
            <translation>Preset speichern unter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Save Preset As…</source>
            <translation>Preset speichern unter…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Save Recordings to {folder}…</source>
            <translation>Aufnahmen speichern in {folder}…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Save Selection as Audio File</source>
            <translation>Auswahl als Audiodatei speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Save Selection as Audio File…</source>
            <translation>Auswahl als Audiodatei speichern…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Save Spoken Text</source>
            <translation>Gesprochenen Text speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Save Spoken Text as Audio File…</source>
            <translation>Gesprochenen Text als Audiodatei speichern…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Save Spoken Text…</source>
            <translation>Gesprochenen Text speichern…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Save Style</source>
            <translation>Stil speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Save Text</source>
            <translation>Text speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Save Text…</source>
            <translation>Text speichern…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>Save the averaged spectrum as a curve, or load saved curves to compare with</source>
            <translation>Das gemittelte Spektrum als Kurve speichern oder gespeicherte Kurven zum Vergleich laden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Save the boundaries that you moved in {sound}?</source>
            <translation>Die verschobenen Grenzen in {sound} speichern?</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Save the changes to the labels of {sound}?</source>
            <translation>Änderungen an den Beschriftungen von {sound} speichern?</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Save the changes to the text of {sound}?</source>
            <translation>Die Änderungen am Text von {sound} speichern?</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/keys/key_panel.py" />
            <source>Save the keys beside the recording, as NAME.keys.toml; exports use them</source>
            <translation>Die Keyframes neben der Aufnahme als NAME.keys.toml speichern; Exporte verwenden sie</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Save the keys that you edited in {sound}?</source>
            <translation>Die bearbeiteten Keyframes in {sound} speichern?</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Save the spoken text as WAV, with its words and phones in a TextGrid beside it</source>
            <translation>Gesprochenen Text als WAV speichern, mit Wörtern und Phonen in einem TextGrid daneben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Save the style to its file</source>
            <translation>Den Stil in seine Datei speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Save the style under another name</source>
            <translation>Den Stil unter anderem Namen speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Save the words and phones of the audio file as a TextGrid, which Export can use</source>
            <translation>Wörter und Phone der Audiodatei als TextGrid speichern, das der Export verwenden kann</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Save to</source>
            <translation>Speichern in</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Save Words and Phones</source>
            <translation>Wörter und Phone speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Save Words and Phones…</source>
            <translation>Wörter und Phone speichern…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Saved the spoken text as {path}, with a label file of its words and phones</source>
            <translation>Gesprochener Text gespeichert als {path}, mit einer Beschriftungsdatei der Wörter und Phone</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/sound_words.py" />
            <source>Saved words and phones as {path}.</source>
            <translation>Wörter und Phone als {path} gespeichert.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Saves a copy without {lost}.</source>
            <translation>Speichert eine Kopie ohne {lost}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Save…</source>
            <translation>Speichern…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>Saving spoken text…</source>
            <translation>Gesprochener Text wird gespeichert …</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>Say nothing for two seconds while the background noise is measured</source>
            <translation>Zwei Sekunden nicht sprechen, während das Hintergrundgeräusch gemessen wird</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>Say only the burst of the p, in quick succession, without a vowel</source>
            <translation>Nur das Platzen des p, in rascher Folge, ohne Vokal danach</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>schwa</source>
            <translation>Schwa</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/score_strip.py" />
            <source>Score</source>
            <translation>Bewertung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/score_strip.py" />
            <source>Score of</source>
            <translation>Bewertet wird</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Scores</source>
            <translation>Werte</translation>
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
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_view.py" />
            <source>Scroll on by a page when playback leaves the view</source>
            <translation>Weiterblättern, wenn die Wiedergabe den Ausschnitt verlässt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Search</source>
            <translation>Suchen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/variables_panel.py" />
            <source>Search for the frequency ranges that separate the two phonemes best</source>
            <translation>Frequenzbereiche suchen, die die beiden Phoneme am besten trennen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Search for thresholds that fit the loaded takes and recordings, starting from the current ones</source>
            <translation>Schwellen suchen, die zu den geladenen Takes und Aufnahmen passen, ausgehend von den aktuellen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/preset_picker.py" />
            <source>Search presets</source>
            <translation>Presets suchen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Search the manual</source>
            <translation>Handbuch durchsuchen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Searching in the background…</source>
            <translation>Suche läuft im Hintergrund…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Second formant</source>
            <translation>Zweiter Formant</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/figures_table.py" />
            <source>Second minus first in percentage points; more than the number after ± is more than chance</source>
            <translation>Zweite minus erste in Prozentpunkten; mehr als die Zahl nach ± ist mehr als Zufall</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>Segments</source>
            <translation>Segmente</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>Segments in the cell</source>
            <translation>Segmente der Zelle</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Select a take to play and trim it</source>
            <translation>Take zum Anhören und Zuschneiden wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Select All</source>
            <translation>Alles auswählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>Selection</source>
            <translation>Auswahl</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Send OSC to</source>
            <translation>OSC senden an</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Send phonemes, mouth shapes and blend shape weights over the network, as OSC messages of the VMC protocol that VTuber programs use</source>
            <translation>Phoneme, Mundformen und Blendshape-Gewichte über das Netzwerk senden, als OSC-Nachrichten des VMC-Protokolls der VTuber-Programme</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_model.py" />
            <source>Sending: {n} packets</source>
            <translation>Sendet: {n} Pakete</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>sensitivity to {sound}</source>
            <translation>Empfindlichkeit für {sound}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>Sentence</source>
            <translation>Satz</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>sentence</source>
            <translation>Satz</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Sentence language</source>
            <translation>Sprache der Sätze</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>Separate</source>
            <translation>Trennen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/variables_panel.py" />
            <source>Separation</source>
            <translation>Trennung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/variables_panel.py" />
            <source>Separation: probability that a threshold tells two frames of different phonemes apart; 50 % is chance level</source>
            <translation>Trennung: Wahrscheinlichkeit, mit der eine Schwelle zwei Frames verschiedener Phoneme unterscheidet; 50 % ist Zufall</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Serbian</source>
            <translation>Serbisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/serve_dialog.py" />
            <source>Serve</source>
            <translation>Server</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Serve…</source>
            <translation>Server…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/serve_dialog.py" />
            <source>Serving {address}</source>
            <translation>Server läuft: {address}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/serve_dialog.py" />
            <source>Serving {words}</source>
            <translation>Server läuft: {words}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Set all sliders to 0</source>
            <translation>Alle Regler auf 0 setzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/preset_choice.py" />
            <source>Set as {letter}</source>
            <translation>Als {letter} setzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Set Current as B</source>
            <translation>Aktuelles als B setzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Set of blend shapes that the receiving avatar has: that of the head’s mouth table, or another one</source>
            <translation>Satz von Blendshapes des empfangenden Avatars: der aus der Mundtabelle des Kopfes oder ein anderer</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/mapping_dialog.py" />
            <source>Set of blend shapes that the speech moves</source>
            <translation>Satz von Blendshapes, den die Sprache bewegt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Set others and blinks to 0</source>
            <translation>Andere und Blinzeln auf 0</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Set others to 0</source>
            <translation>Andere auf 0</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Set reach, speed, closures and asymmetry so that rules move most like the recorded faces in use</source>
            <translation>Reichweite, Tempo, Verschlüsse und Asymmetrie so einstellen, dass sich Regeln möglichst wie die verwendeten aufgezeichneten Gesichter bewegen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Set start, end of the range</source>
            <translation>Anfang, Ende des Bereichs setzen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Sets amplitudes below the threshold to 0.</source>
            <translation>Setzt Amplituden unter der Schwelle auf 0.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>sh</source>
            <translation>sch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Shan (Tai Yai)</source>
            <translation>Shan</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Shape (%)</source>
            <translation>Form (%)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/figures.py" />
            <source>Share of clear a, e, i, o and u frames recognised correctly</source>
            <translation>Anteil der richtig erkannten Frames von klarem a, e, i, o und u</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/figures.py" />
            <source>Share of frames of the ten phonemes recognised correctly</source>
            <translation>Anteil der richtig erkannten Frames der zehn Phoneme</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/figures.py" />
            <source>Share of frames with the correct one of six mouth shapes</source>
            <translation>Anteil der Frames mit der richtigen von sechs Mundformen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/figures.py" />
            <source>Share of silent frames recognised as silence</source>
            <translation>Anteil der stillen Frames, die als Stille erkannt werden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/figures.py" />
            <source>Share of speech frames recognised as silence</source>
            <translation>Anteil der gesprochenen Frames, die als Stille erkannt werden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Share of the expression that speech takes away: 0 nothing, 1 everything</source>
            <translation>Anteil des Ausdrucks, den die Sprache wegnimmt: 0 nichts, 1 alles</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Shift+Left, Shift+Right</source>
            <translation>Umschalt+Links, Umschalt+Rechts</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/ship_dialog.py" />
            <source>Ship</source>
            <translation>Ausliefern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/ship_dialog.py" />
            <source>Ship Preset</source>
            <translation>Preset ausliefern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Ship Preset…</source>
            <translation>Preset ausliefern…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Short Buffer: 10 ms, Lowest Latency</source>
            <translation>Kurzer Puffer: 10 ms, geringste Latenz</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Shortest time for which a phoneme is shown. The bar shows how long the current one has lasted.</source>
            <translation>Kürzeste Dauer, die ein Phonem gezeigt wird. Der Balken zeigt, wie lange das aktuelle schon dauert.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Shortest time that a mouth shape lasts; shorter ones are extended or merged with their neighbours</source>
            <translation>Kürzeste Zeit, die eine Mundform dauert; kürzere werden verlängert oder mit ihren Nachbarn vereint</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Shortest time that a recognised phoneme lasts.</source>
            <translation>Kürzeste Zeit, die ein erkanntes Phonem dauert.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>Show</source>
            <translation>Anzeigen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Show a second head in sync, moved by another driver or preset</source>
            <translation>Einen zweiten Kopf synchron zeigen, den eine andere Steuerung oder ein anderes Preset bewegt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/scroll_view.py" />
            <source>Show all that the microphone recorded since Clear on its own time axis (Ctrl+B)</source>
            <translation>Alles seit dem Leeren Aufgenommene auf eigener Zeitachse zeigen (Strg+B)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Show below the sonagram:</source>
            <translation>Unter dem Sonagramm zeigen:</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Show expressions that other programs send: /expression NAME 0..1, or the blend shapes of a face tracker (VMC)</source>
            <translation>Ausdrücke zeigen, die andere Programme senden: /expression NAME 0..1 oder die Blendshapes einer Gesichtserfassung (VMC)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/head_view.py" />
            <source>Show head and shoulders from the front</source>
            <translation>Kopf und Schultern von vorn zeigen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Show History</source>
            <translation>Verlauf anzeigen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Show in the confusion matrix how much more often the current preset gives each result</source>
            <translation>In der Konfusionsmatrix zeigen, wie viel häufiger das aktuelle Preset jedes Ergebnis liefert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/mapping_dialog.py" />
            <source>Show it on the face</source>
            <translation>Am Gesicht zeigen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Show Man</source>
            <translation>Mann zeigen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>Show Spread</source>
            <translation>Streuung anzeigen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>Show Table</source>
            <translation>Tabelle anzeigen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/frame_views.py" />
            <source>Show the amplitude in dB</source>
            <translation>Amplitude in dB zeigen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Show the curves of blend shapes, whose keys can be edited</source>
            <translation>Die Kurven der Blendshapes zeigen, deren Keyframes sich bearbeiten lassen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Show the man's head that ships with the program</source>
            <translation>Den Kopf des Mannes zeigen, der zum Programm gehört</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/head_view.py" />
            <source>Show the mouth from the front</source>
            <translation>Den Mund von vorn zeigen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_editor.py" />
            <source>Show the rules for this phoneme only</source>
            <translation>Nur die Regeln für dieses Phonem zeigen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/sonagram.py" />
            <source>Show the sonagram after all active filters, as recognisers that use the filters see it</source>
            <translation>Das Sonagramm nach allen aktiven Filtern zeigen, so wie Erkenner mit Filtern es sehen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/head_view.py" />
            <source>Show the whole head from the front (Home or double-click)</source>
            <translation>Ganzen Kopf von vorn zeigen (Pos1 oder Doppelklick)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Show the woman's head that ships with the program</source>
            <translation>Den Kopf der Frau zeigen, der zum Programm gehört</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/pages.py" />
            <source>Show the {name} page (Ctrl+{number})</source>
            <translation>Seite {name} anzeigen (Strg+{number})</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Show Woman</source>
            <translation>Frau zeigen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Shows the spectrum after triangular filters on the mel scale (HTK); variables can measure it.</source>
            <translation>Zeigt das Spektrum nach Dreiecksfiltern auf der Mel-Skala (HTK); Variablen können es messen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>Signal lost between microphone and program since listening began</source>
            <translation>Signal, das seit Beginn des Zuhörens zwischen Mikrofon und Programm verloren ging</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Silence</source>
            <translation>Stille</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>silence</source>
            <translation>Stille</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>silence if all hold</source>
            <translation>Stille, wenn alle gelten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/figures.py" />
            <source>Silence recall</source>
            <translation>Erkannte Stille</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>silence recall falls from {old} % to {new} %</source>
            <translation>erkannte Stille fällt von {old} % auf {new} %</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>silent</source>
            <translation>stumm</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>Since Clear</source>
            <translation>Seit Leeren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>Since Clear, {s:.1f} s</source>
            <translation>Seit Leeren, {s:.1f} s</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>sine</source>
            <translation>Sinus</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Single Sounds</source>
            <translation>Einzelne Laute</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Sinhala</source>
            <translation>Singhalesisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Skip</source>
            <translation>Überspringen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Skip this step (Right arrow)</source>
            <translation>Diesen Schritt überspringen (Pfeil rechts)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Skip ▶</source>
            <translation>Überspringen ▶</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Sliders and timeline</source>
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
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/preset_choice.py" />
            <source>Small network</source>
            <translation>Kleines Netz</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/distribution.py" />
            <source>Smallest {variable} of {sound}: {value}.</source>
            <translation>Kleinstes {variable} von {sound}: {value}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>smile</source>
            <translation>Lächeln</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Smile follows the voice</source>
            <translation>Lächeln folgt der Stimme</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/keys/key_lanes.py" />
            <source>smooth keys</source>
            <translation>Keyframes glätten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/keys/key_lanes.py" />
            <source>Smooth Range</source>
            <translation>Bereich glätten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Smooth, raise or lower range</source>
            <translation>Bereich glätten, anheben oder senken</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Smoothing</source>
            <translation>Glättung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Smoothing of recorded faces</source>
            <translation>Glättung aufgezeichneter Gesichter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/phoneme_view.py" />
            <source>Smoothing: {recognised} → {phoneme}</source>
            <translation>Glättung: {recognised} → {phoneme}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/sonagram.py" />
            <source>Sonagram</source>
            <translation>Sonagramm</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>sorrow</source>
            <translation>Trauer</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>Sort the variables by how well they separate this</source>
            <translation>Variablen danach sortieren, wie gut sie dieses Phonem trennen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Sound</source>
            <translation>Laut</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Sound alone (network)</source>
            <translation>Nur Ton (Netz)</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/output.py" />
            <source>sound cannot be slowed, since the package audiotsm is missing; pip install audiotsm</source>
            <translation>langsamere Wiedergabe nicht möglich, da das Paket audiotsm fehlt; installieren mit pip install audiotsm</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Sound {index} of {n}</source>
            <translation>Laut {index} von {n}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/phoneme_data_panel.py" />
            <source>Sounds</source>
            <translation>Laute</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Source</source>
            <translation>Quelle</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Source of the signal: file, microphone, tone or text</source>
            <translation>Quelle des Signals: Datei, Mikrofon, Ton oder Text</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/sonagram.py" />
            <source>Spacing of the frequencies in the sonagram: linear, mel or logarithmic</source>
            <translation>Teilung der Frequenzachse im Sonagramm: linear, mel oder logarithmisch</translation>
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
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Speak</source>
            <translation>Vorlesen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/welcome.py" />
            <source>Speak and watch the phonemes; nothing is recorded until you press R.</source>
            <translation>Sprechen und die Phoneme mitlesen; aufgenommen wird erst mit der Taste R.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Speak Text</source>
            <translation>Text vorlesen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Speak the text with a synthetic voice (Ctrl+Return); Escape stops it</source>
            <translation>Den Text von einer Sprechstimme vorlesen lassen (Strg+Eingabetaste); Esc beendet es</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/take_list.py" />
            <source>Speaker</source>
            <translation>Sprecher</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>speaker</source>
            <translation>Sprecher</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/take_list.py" />
            <source>Speaker of the take</source>
            <translation>Sprecher des Takes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Speaker of the takes recorded from now on</source>
            <translation>Sprecher der ab jetzt aufgenommenen Takes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Speaker whose words are read from the labels</source>
            <translation>Sprecher, dessen Wörter aus den Beschriftungen gelesen werden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Speaker: {speaker}</source>
            <translation>Sprecher: {speaker}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>Speakers</source>
            <translation>Sprecher</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Spectra</source>
            <translation>Spektren</translation>
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
            <location filename="../../../phonemeanalyser/desktop/analyse/page.py" />
            <source>Spectrum of the current window of 46.4 ms, after all active filters</source>
            <translation>Spektrum des aktuellen Fensters von 46.4 ms, nach allen aktiven Filtern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/preset_choice.py" />
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
            <source>Speech priority</source>
            <translation>Vorrang der Sprache</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Speech rate</source>
            <translation>Sprechtempo</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Speech rate of the voices of espeak-ng; people speak four to five syllables a second</source>
            <translation>Sprechtempo der Stimmen von espeak-ng; Menschen sprechen vier bis fünf Silben pro Sekunde</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Speed</source>
            <translation>Tempo</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Speed {percent:.0f} %</source>
            <translation>Tempo {percent:.0f} %</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/label_tiers.py" />
            <source>split label</source>
            <translation>Beschriftung teilen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Split Label at Cursor (Enter)</source>
            <translation>Beschriftung am Cursor teilen (Eingabetaste)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Split Word or Phone at Cursor (Enter)</source>
            <translation>Wort oder Phon am Cursor teilen (Eingabetaste)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/sound_words.py" />
            <source>splitting of a phone</source>
            <translation>Teilen eines Phons</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/sound_words.py" />
            <source>splitting of a word</source>
            <translation>Teilen eines Wortes</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Stability</source>
            <translation>Stabilität</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>Standard deviation of the level, as a band about each curve</source>
            <translation>Standardabweichung des Pegels, als Band um jede Kurve</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/storage/replacing.py" />
            <source>standard output cannot be written ({error}); free some space, or name a file with -o</source>
            <translation>Die Standardausgabe lässt sich nicht schreiben ({error}); Platz schaffen oder mit -o eine Datei angeben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/storage/replacing.py" />
            <source>standard output is closed; name a file with -o</source>
            <translation>Die Standardausgabe ist geschlossen; mit -o eine Datei angeben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Start</source>
            <translation>Starten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/figures_table.py" />
            <source>Start (s)</source>
            <translation>Anfang (s)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Start frequency of the sweep</source>
            <translation>Startfrequenz des Gleittons</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Start Label at Cursor</source>
            <translation>Beschriftung am Cursor beginnen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Start recording after a two-second countdown (Return)</source>
            <translation>Aufnahme nach zwei Sekunden Countdown starten (Eingabetaste)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Start Selection at Cursor</source>
            <translation>Auswahl am Cursor beginnen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Start the marked range at the playback position ([)</source>
            <translation>Markierten Bereich an der Abspielposition beginnen ([)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Start value of all random motion; the same number gives the same blinks and head motion again</source>
            <translation>Startwert aller zufälligen Bewegung; dieselbe Zahl ergibt wieder dasselbe Blinzeln und dieselbe Kopfbewegung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/serve_dialog.py" />
            <source>Starting or stopping…</source>
            <translation>Wird gestartet oder gestoppt…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Status</source>
            <translation>Status</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Stop</source>
            <translation>Stopp</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Stop (Escape); a file returns to its start</source>
            <translation>Stopp (Esc); eine Datei springt an ihren Anfang</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Stop Aligning</source>
            <translation>Ausrichten abbrechen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>Stop Averaging</source>
            <translation>Mitteln abbrechen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Stop opening this folder; the takes of the last one stay</source>
            <translation>Öffnen des Ordners abbrechen; die Takes des vorigen bleiben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Stop recording (R)</source>
            <translation>Aufnahme beenden (R)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Stop the search; the preset stays unchanged</source>
            <translation>Suche beenden; das Preset bleibt unverändert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/phoneme_data_panel.py" />
            <source>Stop {percent:.0f} %</source>
            <translation>Stopp {percent:.0f} %</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/serve_dialog.py" />
            <source>Stopped</source>
            <translation>Gestoppt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/exports.py" />
            <source>stopped by an unexpected error</source>
            <translation>durch einen unerwarteten Fehler abgebrochen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/serve_dialog.py" />
            <source>Streams and files of other programs are recognised with this preset. The server runs until it is stopped or the program quits.</source>
            <translation>Streams und Dateien anderer Programme werden mit diesem Preset erkannt. Der Server läuft, bis er gestoppt oder das Programm beendet wird.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_panel.py" />
            <source>Strength of the expression: {name}</source>
            <translation>Stärke des Ausdrucks: {name}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Style</source>
            <translation>Stil</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Style in which the face speaks: a built-in one, or one of your own from the styles folder</source>
            <translation>Stil, in dem das Gesicht spricht: ein mitgelieferter oder ein eigener aus dem Ordner der Stile</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Style {side}</source>
            <translation>Stil {side}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Styles of speaking (*.toml)</source>
            <translation>Sprechstile (*.toml)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Such a small gain on so little speech may be due to chance. Listen to both presets before you decide.</source>
            <translation>Ein so kleiner Gewinn bei so wenig Sprache kann Zufall sein. Vor der Entscheidung beide Presets anhören.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/variables_panel.py" />
            <source>Suggest</source>
            <translation>Vorschlagen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/banner.py" />
            <source>Suggested action</source>
            <translation>Vorgeschlagene Aktion</translation>
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
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Switch</source>
            <translation>Wechseln</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>Switch all filters off, or back to their previous state (B)</source>
            <translation>Alle Filter ausschalten oder zurück auf den vorigen Stand (B)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Switch between A and B</source>
            <translation>Zwischen A und B wechseln</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Switch from {name} to the microphone and record?</source>
            <translation>Von {name} zum Mikrofon wechseln und aufnehmen?</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>switch to recogniser {name}</source>
            <translation>zum Erkenner {name} wechseln</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>switch {what} off</source>
            <translation>{what} ausschalten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>switch {what} on</source>
            <translation>{what} einschalten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>syllable</source>
            <translation>Silbe</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_layout.py" />
            <source>Syllables</source>
            <translation>Silben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/speech/pinyin/timing.py" />
            <source>syllables per second</source>
            <translation>Silben je Sekunde</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>syllables/s</source>
            <translation>Silben/s</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_model.py" />
            <source>synthetic voice</source>
            <translation>synthetische Stimme</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>System</source>
            <translation>System</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>System default</source>
            <translation>Systemstandard</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Table</source>
            <translation>Tabelle</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Table of recorded faces</source>
            <translation>Tabelle aufgezeichneter Gesichter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Table of recorded faces whose motion is used for new sentences; `phonemeanalyser performance build` makes one</source>
            <translation>Tabelle aufgezeichneter Gesichter, deren Bewegung für neue Sätze verwendet wird; `phonemeanalyser performance build` erstellt eine</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Table of the mouth shape of each phoneme, and of the blend shapes that form it</source>
            <translation>Tabelle der Mundform jedes Phonems und der Blendshapes, die sie bilden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Table of the style</source>
            <translation>Tabelle des Stils</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>Table saved as {path}</source>
            <translation>Tabelle gespeichert als {path}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>Tables (*.csv)</source>
            <translation>Tabellen (*.csv)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Tables of recorded faces (*.sqlite)</source>
            <translation>Tabellen aufgezeichneter Gesichter (*.sqlite)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/docks.py" />
            <source>Tabs of the docks</source>
            <translation>Reiter der Docks</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>take</source>
            <translation>Take</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/take_list.py" />
            <source>Takes</source>
            <translation>Takes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Talk</source>
            <translation>Sprechen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/ship_dialog.py" />
            <source>Target</source>
            <translation>Ziel</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/table.py" />
            <source>targets names {name}, which is no movestate; use one of movestates</source>
            <translation>targets nennt {name}, das ist kein Movestate; eines aus movestates nehmen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Tatar</source>
            <translation>Tatarisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/serve_dialog.py" />
            <source>TCP port; 0 lets the system choose a free one</source>
            <translation>TCP-Port; bei 0 wählt das System einen freien</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>Test</source>
            <translation>Test</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/rule_dialogs.py" />
            <source>Testing it on the labelled recordings…</source>
            <translation>Wird an den beschrifteten Aufnahmen getestet…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/sources.py" />
            <source>Text</source>
            <translation>Text</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>text</source>
            <translation>Text</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>Text of the recording, or text to speak: Ctrl+Return speaks it, Ctrl+Shift+Return aligns it with the recording</source>
            <translation>Text der Aufnahme oder vorzulesender Text: Strg+Eingabetaste liest ihn vor, Strg+Umschalt+Eingabetaste richtet ihn an der Aufnahme aus</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>Text on the Talk page</source>
            <translation>Text der Seite Sprechen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Text or labels beside each file</source>
            <translation>Text oder Beschriftungen neben den Dateien</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Texts (*.txt)</source>
            <translation>Texte (*.txt)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Thai</source>
            <translation>Thailändisch</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_writing.py" />
            <source>the .glb would be larger than {largest_buffer} MB; leave out some movestates</source>
            <translation>Die .glb-Datei würde größer als {largest_buffer} MB; einige Blendshapes weglassen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/storage/files.py" />
            <source>the archive is compressed in a way that NumPy does not use</source>
            <translation>das Archiv ist auf eine Weise komprimiert, die NumPy nicht verwendet</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/storage/files.py" />
            <source>the archive is damaged</source>
            <translation>das Archiv ist beschädigt</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/storage/files.py" />
            <source>the arrays have more than {largest} bytes</source>
            <translation>die Arrays haben mehr als {largest} Byte</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/stream.py" />
            <source>the audio device could not be opened ({error}); check that it is connected and not in use, or choose another</source>
            <translation>Das Audiogerät ließ sich nicht öffnen ({error}); prüfen, ob es angeschlossen und frei ist, oder ein anderes wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>The audio device does not report which part of it the input takes.</source>
            <translation>Das Audiogerät meldet nicht, welcher Teil davon auf den Eingang entfällt.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/original_model.py" />
            <source>The audio of {recording} is missing, so only its face is shown; put the recordings back into {folder}.</source>
            <translation>Der Ton zu {recording} fehlt, daher ist nur das Gesicht zu sehen; die Aufnahmen wieder in {folder} ablegen.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/stream.py" />
            <source>the audio system does not respond ({error}); check that it is running</source>
            <translation>Das Audiosystem antwortet nicht ({error}); prüfen, ob es läuft</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/curves.py" />
            <source>The averaged spectra can't be kept for the next start: {error}</source>
            <translation>Die gemittelten Spektren können nicht für den nächsten Start gesichert werden: {error}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>The background noise has not been recorded yet. Go back and keep quiet for two seconds.</source>
            <translation>Das Hintergrundgeräusch ist noch nicht aufgenommen. Zurückgehen und zwei Sekunden nicht sprechen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>The background noise was as loud as a voice ({db} dBFS); keep quiet and measure it again.</source>
            <translation>Das Hintergrundgeräusch war so laut wie eine Stimme ({db} dBFS); nicht sprechen und noch einmal messen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/model.py" />
            <source>The background noise was not measured, because the microphone stopped. Measure it again.</source>
            <translation>Das Hintergrundgeräusch wurde nicht gemessen, weil das Mikrofon gestoppt wurde. Noch einmal messen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>the beginning of {place}</source>
            <translation>der Anfang von {place}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/skin.py" />
            <source>the bones of its skeleton go in a circle at node {node}; export it again</source>
            <translation>Die Knochen des Skeletts bilden bei Knoten {node} einen Kreis; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>the buffer in its text is no base64; export it again</source>
            <translation>Der eingebettete Puffer ist kein Base64; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/preset_dialogs.py" />
            <source>The calibrated preset is in use but not saved yet.</source>
            <translation>Das kalibrierte Preset wird verwendet, ist aber noch nicht gespeichert.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/dsp/formants.py" />
            <source>the ceiling</source>
            <translation>die Obergrenze</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/stream.py" />
            <source>the channel</source>
            <translation>der Kanal</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/inspection/averaged_spectrum.py" />
            <source>the columns must be {columns}, found {rows}</source>
            <translation>Die Spalten müssen {columns} sein, gefunden {rows}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/speech/program.py" />
            <source>the command {template} cannot be read ({error}); close its quotes</source>
            <translation>Der Befehl {template} ist nicht lesbar ({error}); Anführungszeichen schließen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/speech/program.py" />
            <source>the command {template} does not say where the sound goes; put {output} where the name of a WAV file belongs, and {text} where the text does</source>
            <translation>Der Befehl {template} sagt nicht, wohin die Audiodatei kommt; {output} an die Stelle des Namens der WAV-Datei setzen und {text} an die des Textes</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/shipping/compiling.py" />
            <source>the compiler zig cannot compile the runtime ({why}); install a newer one</source>
            <translation>Der Compiler zig kann die Laufzeitbibliothek nicht kompilieren ({why}); neueren installieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/shipping/compiling.py" />
            <source>the compiler zig does not run ({error}); install it again</source>
            <translation>Der Compiler zig läuft nicht ({error}); neu installieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf.py" />
            <source>the corners of its triangles are no whole numbers; export it again</source>
            <translation>Die Ecken der Dreiecke sind keine ganzen Zahlen; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>the default head or a custom face</source>
            <translation>Standardkopf oder eigenes Gesicht</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/shipping/targets.py" />
            <source>the demo page needs {words}, which npm fetches, and there is no npm; install Node.js, {otherwise}</source>
            <translation>Die Demoseite braucht {words}, die npm lädt, und npm fehlt; Node.js installieren, {otherwise}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>the disk has become read-only</source>
            <translation>das Laufwerk ist jetzt schreibgeschützt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>the disk is full</source>
            <translation>das Laufwerk ist voll</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>the disk refuses to take more ({reason})</source>
            <translation>das Laufwerk nimmt nichts mehr an ({reason})</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>the disk takes no larger file</source>
            <translation>das Laufwerk nimmt keine größere Datei an</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/textgrid.py" />
            <source>the end of the file</source>
            <translation>das Ende der Datei</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/textgrid.py" />
            <source>the end of the file or a text without its closing quote</source>
            <translation>das Ende der Datei oder ein Text ohne schließendes Anführungszeichen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>the end of {place}</source>
            <translation>das Ende von {place}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/ship_dialog.py" />
            <source>The folder will contain the preset, the runtime that recognises with it, and a README with the next steps.</source>
            <translation>Der Ordner enthält das Preset, die Laufzeitbibliothek, die damit erkennt, und eine README mit den nächsten Schritten.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>The format of the microphone changed during the recording; the part before the change is in {files}.</source>
            <translation>Das Format des Mikrofons hat sich während der Aufnahme geändert; der Teil davor ist in {files}.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/animation.py" />
            <source>the frame rate</source>
            <translation>die Bildrate</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/exports/exporter.py" />
            <source>the frame rate of {name} must be {kind} in {lowest_rate}..{highest_rate} frames per second, got {rate}; choose another</source>
            <translation>Die Bildrate von {name} muss {kind} in {lowest_rate}..{highest_rate} Bildern je Sekunde sein, gefunden {rate}; andere wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/inspection/averaged_spectrum.py" />
            <source>the frequencies must rise from row to row</source>
            <translation>Die Frequenzen müssen von Zeile zu Zeile steigen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/rendering/passes.py" />
            <source>the graphics driver has no memory for a picture of {size}x{size_2} pixels; make it smaller</source>
            <translation>Der Grafiktreiber hat keinen Platz für ein Bild von {size}x{size_2} Pixeln; kleiner wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/rendering/passes.py" />
            <source>the graphics driver refuses the program's shaders ({splitlines}); update the driver</source>
            <translation>Der Grafiktreiber lehnt die Shader des Programms ab ({splitlines}); Treiber aktualisieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/head_view.py" />
            <source>The head cannot be shown: {sentence}.</source>
            <translation>Der Kopf lässt sich nicht anzeigen: {sentence}.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/encoder/head.py" />
            <source>the head of the encoder is of a newer version; update the program</source>
            <translation>Der Kopf des Encoders hat eine neuere Version; Programm aktualisieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/inspection/averaged_spectrum.py" />
            <source>the header announces {n_bins} bins (1..{most_bins}), found {points}</source>
            <translation>Die Kopfdaten kündigen {n_bins} Frequenzen an (1..{most_bins}), gefunden {points}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/inspection/averaged_spectrum.py" />
            <source>the header lacks '{key}'</source>
            <translation>In den Kopfdaten fehlt '{key}'</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>The history can't be labelled, since it isn't an audio file yet. Save a selection of it by the menu Selection, open that file, and label it.</source>
            <translation>Der Verlauf lässt sich nicht beschriften, da er noch keine Audiodatei ist. Eine Auswahl über das Menü Auswahl speichern, diese Datei öffnen und beschriften.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/session.py" />
            <source>The history is empty, since the microphone was not used yet. Press Space to listen, then try again.</source>
            <translation>Der Verlauf ist leer, da das Mikrofon noch nicht benutzt wurde. Mit der Leertaste zuhören, dann noch einmal versuchen.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/live/recorder.py" />
            <source>The history is not kept any more ({reason}); free some space on the disk.</source>
            <translation>Der Verlauf wird nicht mehr gespeichert ({reason}); Platz auf dem Laufwerk schaffen.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>the indices of a sparse accessor are of type {kind}; export it again</source>
            <translation>Die Indizes eines dünn besetzten Accessors sind vom Typ {kind}; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>The input takes {ms:.0f} ms of it, which the latency display now includes.</source>
            <translation>Davon entfallen {ms:.0f} ms auf den Eingang; die Latenzanzeige rechnet sie jetzt mit.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>the kind of file</source>
            <translation>die Art der Datei</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>the kind of object</source>
            <translation>die Art des Objekts</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>the kind of tier {number}</source>
            <translation>die Art von Spur {number}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>The labels have no such phoneme</source>
            <translation>Dieses Phonem kommt in den Beschriftungen nicht vor</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/figures.py" />
            <source>The labels hold {n} of the 10 phonemes, and macro F1 is of these: {names}.</source>
            <translation>Die Beschriftung enthält {n} der 10 Phoneme; Makro-F1 gilt für diese: {names}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>The language is guessed from the text. If it is wrong, type the right one.</source>
            <translation>Die Sprache wird aus dem Text erschlossen. Ist sie falsch, die richtige eintippen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>The language isn’t set, and it isn’t detected; choose it beside the text.</source>
            <translation>Die Sprache ist nicht gewählt und wird nicht erkannt; neben dem Text wählen.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/espeak.py" />
            <source>the language of a text is not guessed; name it with --language, such as {some}</source>
            <translation>Die Sprache eines Textes wird nicht geraten; mit --language angeben, etwa {some}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>The last column is cross-validated: each {left_out} in turn is held out and measured.</source>
            <translation>Die letzte Spalte ist kreuzvalidiert: Je eine Einheit ({left_out}) wird zurückgehalten und gemessen.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/stream.py" />
            <source>the latency</source>
            <translation>die Latenz</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>The latency could not be measured: {why}.</source>
            <translation>Die Latenz ließ sich nicht messen: {why}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>the length of {what}</source>
            <translation>die Länge ({what})</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/rule_dialogs.py" />
            <source>The loaded recordings have no usable labels.</source>
            <translation>Die geladenen Aufnahmen haben keine brauchbaren Beschriftungen.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/dsp/spectrum.py" />
            <source>the maximum of a normalised spectrum must be above 0, got {maximum}; choose another</source>
            <translation>Das Maximum eines normalisierten Spektrums muss über 0 liegen, gefunden {maximum}; anderes wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/rendering/renderer.py" />
            <source>the mesh has no triangles, so there is nothing to be seen; choose another one</source>
            <translation>Das Mesh hat keine Dreiecke, daher ist nichts zu sehen; anderes wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/mesh.py" />
            <source>the mesh has the vertices 0..{len}, got {worst}; choose one of them</source>
            <translation>Das Mesh hat die Eckpunkte 0..{len}, gefunden {worst}; einen davon wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/exports/gltf.py" />
            <source>the mesh is a damaged glTF file; export it anew from your modelling program</source>
            <translation>Das Mesh ist eine beschädigte glTF-Datei; im Modellierprogramm neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>The microphone delivers digital silence, which sets no thresholds; check that it is on and not muted.</source>
            <translation>Das Mikrofon liefert digitale Stille, aus der sich keine Schwellen ergeben; prüfen, ob es eingeschaltet und nicht stummgeschaltet ist.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>The microphone has recorded nothing since Clear. Use it first, then add its average.</source>
            <translation>Seit dem Leeren hat das Mikrofon nichts aufgenommen. Zuerst aufnehmen, dann den Mittelwert hinzufügen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>The microphone is back: {status}.</source>
            <translation>Das Mikrofon ist zurück: {status}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>The microphone is back: {status}. {seconds:.1f} s of its signal were lost.</source>
            <translation>Das Mikrofon ist zurück: {status}. {seconds:.1f} s Signal gingen verloren.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/stream.py" />
            <source>the microphone {label} {fault}; choose one of: {known}</source>
            <translation>Das Mikrofon {label} {fault}; eins wählen: {known}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>the microphone {name} is not connected; choose one of: {names}</source>
            <translation>das Mikrofon {name} ist nicht angeschlossen; eines davon wählen: {names}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>the mix</source>
            <translation>die Mischung</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/recognition/model.py" />
            <source>the model is of version {arrays}, and this program reads those up to {format}; update the program, or train the model again</source>
            <translation>Das Modell hat Version {arrays}, dieses Programm liest bis {format}; Programm aktualisieren oder das Modell neu trainieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/presets/model_choice.py" />
            <source>the model of the preset {name} has visemes of its own, which the real-time model does not know; choose another model</source>
            <translation>Das Modell des Presets {name} hat eigene Viseme, die das Echtzeitmodell nicht kennt; ein anderes Modell wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/presets/model_choice.py" />
            <source>the model of the preset {name} has visemes of its own, which the speech encoder does not know; files are recognised without it</source>
            <translation>Das Modell des Presets {name} hat eigene Viseme, die der Sprach-Encoder nicht kennt; Dateien werden ohne ihn erkannt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>the model Whisper base is not on this computer; File &gt; Speech Encoder… downloads it</source>
            <translation>das Modell Whisper base ist nicht auf diesem Computer; Datei &gt; Sprach-Encoder… lädt es herunter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>the most likely one is recognised</source>
            <translation>das wahrscheinlichste wird erkannt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/keys/key_lanes.py" />
            <source>The mouth table does not move {shape}</source>
            <translation>Die Mundtabelle bewegt {shape} nicht</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/morph_mesh.py" />
            <source>the movestates move vertex {numbers}, and the mesh has {mesh}; choose the mesh of theirs</source>
            <translation>Die Blendshapes bewegen Eckpunkt {numbers}, das Mesh hat nur {mesh}; das zugehörige Mesh wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/movestate.py" />
            <source>the name of a movestate is 1..{longest_name} bytes of printable text, got {name}; rename it</source>
            <translation>Der Name eines Blendshapes hat 1..{longest_name} Byte druckbaren Text, gefunden {name}; umbenennen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>the name of movestate {place}</source>
            <translation>der Name von Blendshape {place}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/threedm.py" />
            <source>the name of movestate {place} is no text ({raw}); export it again</source>
            <translation>Der Name von Blendshape {place} ist kein Text ({raw}); neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>the name of tier {number}</source>
            <translation>der Name von Spur {number}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>the name of {place}</source>
            <translation>der Name von {place}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>The nearest of nine mean spectra, as in uLipSync: mouth shapes {percent} % on left-out speakers.</source>
            <translation>Das nächste von neun mittleren Spektren, wie bei uLipSync: Mundformen {percent} % bei ausgelassenen Sprechern.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/encoder/onnx.py" />
            <source>the network cannot be opened ({error}); get it anew</source>
            <translation>Das Netz lässt sich nicht öffnen ({error}); neu beschaffen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>the network does not move {shapes}</source>
            <translation>das Netz bewegt {shapes} nicht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>the network does not move {shapes} and {n} more</source>
            <translation>das Netz bewegt {shapes} und {n} weitere nicht</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/face_network.py" />
            <source>the network is of version {version}, and this program reads {format}; update the program</source>
            <translation>Das Netz hat die Version {version}, dieses Programm liest {format}; das Programm aktualisieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>The new preset is not saved yet.</source>
            <translation>Das neue Preset ist noch nicht gespeichert.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/tone.py" />
            <source>the number of formants</source>
            <translation>die Zahl der Formanten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>the number of intervals in tier {name}</source>
            <translation>die Zahl der Segmente in Spur {name}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>the number of movestates</source>
            <translation>die Zahl der Blendshapes</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/dsp/sonagram.py" />
            <source>the number of rows</source>
            <translation>die Zahl der Zeilen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>the number of tiers</source>
            <translation>die Zahl der Spuren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>the number of vertices of {name}</source>
            <translation>die Zahl der Eckpunkte von {name}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>the number of vertices that move</source>
            <translation>die Zahl der bewegten Eckpunkte</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/preset_choice.py" />
            <source>The offline model recognises files best together with the encoder of Whisper base, which was trained on very many voices. The encoder runs on this computer, takes 250 MB of memory, and is used where a whole file is recognised at once: saving, exporting, aligning with its text.</source>
            <translation>Am besten erkennt das Offline-Modell Dateien zusammen mit dem Encoder von Whisper base, der mit sehr vielen Stimmen trainiert wurde. Der Encoder läuft auf diesem Computer, braucht 250 MB Arbeitsspeicher und wird genutzt, wo eine ganze Datei auf einmal erkannt wird: beim Speichern, Exportieren und Ausrichten an ihrem Text.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/osc.py" />
            <source>the OSC receiver cannot be reached ({strerror}); check its address</source>
            <translation>Der OSC-Empfänger ist nicht erreichbar ({strerror}); seine Adresse prüfen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/osc.py" />
            <source>the OSC receiver {host} is unknown ({error}); check its name, or give its number</source>
            <translation>Der OSC-Empfänger {host} ist unbekannt ({error}); Namen prüfen oder seine Nummer angeben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/conversion/driving.py" />
            <source>the performer is synthetic: no person moved, but a model of one</source>
            <translation>Der Darsteller ist synthetisch: Kein Mensch hat sich bewegt, sondern ein Modell</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/utterance.py" />
            <source>the phones of an utterance must follow each other, found {ipa} at {start} s after {ipa_2} until {end} s; correct the times</source>
            <translation>Die Laute einer Äußerung müssen aufeinander folgen, gefunden {ipa} bei {start} s nach {ipa_2} bis {end} s; Zeiten korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/utterance.py" />
            <source>the phones of an utterance must lie within its sound of {duration} s, found {start}..{end} s; correct the times</source>
            <translation>Die Laute einer Äußerung müssen innerhalb ihrer {duration} s liegen, gefunden {start}..{end} s; Zeiten korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/recognition/rules.py" />
            <source>the pitch set {name} must range upwards within {lowest}..{highest} Hz, got {low}..{high} Hz; correct it</source>
            <translation>Der Grundfrequenz-Satz {name} muss aufsteigend in {lowest}..{highest} Hz liegen, gefunden {low}..{high} Hz; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/preset_dialogs.py" />
            <source>The preset of the last session is no longer there: {paths}. Choose another one in the list.</source>
            <translation>Das Preset der letzten Sitzung ist nicht mehr da: {paths}. Ein anderes in der Liste wählen.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/presets/preset.py" />
            <source>the preset {name} has no decoder, which needs rules and what they confuse; choose a preset such as extended</source>
            <translation>Das Preset {name} hat keinen Decoder: Dafür sind Regeln nötig und was sie verwechseln. Ein Preset wie extended wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/presets/model_choice.py" />
            <source>the preset {name} has no offline model; the real-time model recognises files</source>
            <translation>das Preset {name} hat kein Offline-Modell; das Echtzeitmodell erkennt Dateien</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/presets/model_choice.py" />
            <source>the preset {name} has no real-time model; choose another model</source>
            <translation>das Preset {name} hat kein Echtzeitmodell; ein anderes Modell wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/rule_dialogs.py" />
            <source>The preset {name} has no rules of its own. Make its rules editable in the dock Rules, or begin with Extended rules or rules from takes.</source>
            <translation>Das Preset {name} hat keine eigenen Regeln. Seine Regeln im Dock Regeln bearbeitbar machen oder mit Extended rules oder Regeln aus Takes beginnen.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/shipping/sections.py" />
            <source>the preset {name} has pitch sets, and the runtime cannot choose by pitch; ship one preset for each set</source>
            <translation>Das Preset {name} hat Grundfrequenz-Sätze, und die Laufzeit kann nicht nach Grundfrequenz wählen; für jeden Satz ein Preset ausliefern</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/presets/model_choice.py" />
            <source>the preset {name} was trained without Whisper, and so cannot use it; choose another model</source>
            <translation>das Preset {name} wurde ohne Whisper trainiert und kann es nicht verwenden; ein anderes Modell wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/preset_dialogs.py" />
            <source>The presets of the last session are no longer there: {paths}. Choose others in the list.</source>
            <translation>Die Presets der letzten Sitzung sind nicht mehr da: {paths}. Andere in der Liste wählen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>The program quit during a recording; {seconds:.1f} s from {begun:%Y-%m-%d, %H:%M} were saved to {path}{others}</source>
            <translation>Das Programm wurde während einer Aufnahme beendet; {seconds:.1f} s vom {begun:%Y-%m-%d, %H:%M} sind gespeichert in {path}{others}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_model.py" />
            <source>The range marked in {path} is too short ({seconds:.2f} s). Mark a longer one.</source>
            <translation>Der markierte Bereich in {path} ist zu kurz ({seconds:.2f} s). Einen längeren markieren.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/speech/pinyin/timing.py" />
            <source>the rate</source>
            <translation>das Tempo</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/variables_panel.py" />
            <source>The recogniser {name} cannot use custom variables: this one would be measured and drawn, but would not change any phoneme. A preset with rules of its own can use it.</source>
            <translation>Der Erkenner {name} kann keine eigenen Variablen verwenden: Diese würde gemessen und gezeichnet, aber kein Phonem ändern. Ein Preset mit eigenen Regeln kann sie verwenden.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_editor.py" />
            <source>The recogniser {name} has no rules. Begin with rules from takes, or with Extended rules.</source>
            <translation>Der Erkenner {name} hat keine Regeln. Mit Regeln aus Takes oder mit Extended rules beginnen.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/recognition/spec.py" />
            <source>the recogniser {name} is offered twice, by {packages}; uninstall one of them</source>
            <translation>Der Erkenner {name} wird doppelt angeboten, von {packages}; eins davon deinstallieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/recognition/spec.py" />
            <source>the recogniser {name} needs {words}, and this preset has none; {hint}</source>
            <translation>Der Erkenner {name} braucht {words}, dieses Preset hat keine; {hint}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/calibrate.py" />
            <source>the recogniser {recogniser} does not learn voices; choose one of {built_in}</source>
            <translation>Der Erkenner {recogniser} lernt keine Stimmen; einen wählen aus {built_in}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/presets/model_choice.py" />
            <source>the recogniser {recogniser} has no other model for files; it recognises them itself</source>
            <translation>Der Erkenner {recogniser} hat kein anderes Modell für Dateien; er erkennt sie selbst</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>the recogniser {recogniser} has no other model; choose a preset with a network</source>
            <translation>der Erkenner {recogniser} hat kein anderes Modell; ein Preset mit einem Netz wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/presets/preset.py" />
            <source>the recogniser {recogniser} has no rules; choose a preset with rules, such as extended, or find some with phonemeanalyser rules</source>
            <translation>Der Erkenner {recogniser} hat keine Regeln; ein Preset mit Regeln wählen, etwa extended, oder welche mit phonemeanalyser rules suchen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_model.py" />
            <source>The recogniser {recogniser} has no thresholds to fit. Use the guided calibration instead.</source>
            <translation>Der Erkenner {recogniser} hat keine Schwellen zum Anpassen. Stattdessen die geführte Kalibrierung verwenden.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/fits/fitting.py" />
            <source>the recogniser {recogniser} has no thresholds to fit; choose a preset with thesis rules or rules of its own</source>
            <translation>Der Erkenner {recogniser} hat keine anpassbaren Schwellen; ein Preset mit Regeln der Thesis oder eigenen Regeln wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/shipping/sections.py" />
            <source>the recogniser {recogniser} is another package's, and only those of the program can be shipped; choose another preset</source>
            <translation>Der Erkenner {recogniser} stammt aus einem anderen Paket, ausgeliefert werden nur die des Programms; anderes Preset wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/fits/fitting.py" />
            <source>the recogniser {recogniser} must fit a preset, got a {name}; choose another recogniser</source>
            <translation>Der Erkenner {recogniser} muss ein Preset anpassen, lieferte aber {name}; anderen Erkenner wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/calibrate.py" />
            <source>the recogniser {recogniser} must learn a tuple of presets, got a {name}; choose another recogniser</source>
            <translation>Der Erkenner {recogniser} muss ein Tupel von Presets lernen, lieferte aber {name}; anderen Erkenner wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>The recogniser “{name}” does not use it: it affects the display only.</source>
            <translation>Der Erkenner „{name}“ nutzt es nicht: Es wirkt nur auf die Anzeige.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/microphone.py" />
            <source>the recording continues once the signal is back</source>
            <translation>die Aufnahme geht weiter, sobald das Signal zurück ist</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/takes/sentences.py" />
            <source>the recording does not match this sentence; read it again exactly as shown, without rushing</source>
            <translation>die Aufnahme passt nicht zu diesem Satz; ihn noch einmal genau so vorlesen, wie er dasteht, ohne Eile</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>The recording doesn’t match this text.</source>
            <translation>Die Aufnahme passt nicht zu diesem Text.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>The recording doesn’t match this text; check the text and its language, or align anyway.</source>
            <translation>Die Aufnahme passt nicht zu diesem Text; Text und Sprache prüfen oder trotzdem ausrichten.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>The recording is clipped: {percent} % of the samples are at full scale. Say it again, a little further from the microphone, or turn its level down.</source>
            <translation>Die Aufnahme ist übersteuert: {percent} % der Samples liegen bei Vollaussteuerung. Noch einmal sprechen, etwas weiter weg vom Mikrofon oder mit geringerem Pegel.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/takes/sentences.py" />
            <source>the recording is too short for this sentence; read all of it, without rushing</source>
            <translation>die Aufnahme ist zu kurz für diesen Satz; den ganzen Satz ohne Eile vorlesen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/workbench/labelled_features.py" />
            <source>the recordings were measured with another front end; have them measured anew</source>
            <translation>Die Aufnahmen wurden mit anderer Vorverarbeitung gemessen; neu messen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>The right half of the face stays behind the left one</source>
            <translation>Die rechte Gesichtshälfte bleibt hinter der linken zurück</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_editor.py" />
            <source>The rules of the thesis are fixed; their numbers can be edited.</source>
            <translation>Die Regeln der Thesis stehen fest; ihre Zahlen lassen sich ändern.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>The rules of the thesis with hysteresis, for fewer changes: mouth shapes {percent} % on left-out speakers.</source>
            <translation>Die Regeln der Thesis mit Hysterese, für weniger Wechsel: Mundformen {percent} % bei ausgelassenen Sprechern.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>The rules of the thesis with hysteresis, without aliasing: mouth shapes {percent} % on left-out speakers.</source>
            <translation>Die Regeln der Thesis mit Hysterese, ohne Aliasing: Mundformen {percent} % bei ausgelassenen Sprechern.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>The rules of the thesis with the 21 numbers of a PhonemeData file.</source>
            <translation>Die Regeln der Thesis mit den 21 Zahlen einer PhonemeData-Datei.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>The rules of the thesis, whose every step shows: mouth shapes {percent} % on left-out speakers.</source>
            <translation>Die Regeln der Thesis, von denen jeder Schritt zu sehen ist: Mundformen {percent} % bei ausgelassenen Sprechern.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>the same as an npm package, without the page</source>
            <translation>dasselbe als npm-Paket, ohne die Seite</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/resampling.py" />
            <source>the sample rate</source>
            <translation>die Abtastrate</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/takes/room_noise.py" />
            <source>the samples of background noise must be finite numbers, got NaN or infinity; record the silence again</source>
            <translation>Samples des Hintergrundgeräuschs müssen endliche Zahlen sein, gefunden NaN oder unendlich; Stille neu aufnehmen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_model.py" />
            <source>The sender has stopped</source>
            <translation>Sender sendet nicht mehr</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>the sensitivity for {label} must lie within ±{most_log_odds}, got {value}; choose another value</source>
            <translation>Die Empfindlichkeit für {label} muss in ±{most_log_odds} liegen, gefunden {value}; anderen Wert wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>the server has ended by itself</source>
            <translation>der Server hat sich selbst beendet</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>The silence lasted only {seconds} s; {least} s or more are needed. Keep quiet for longer.</source>
            <translation>Die Stille dauerte nur {seconds} s; nötig sind mindestens {least} s. Länger nicht sprechen.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/live/player.py" />
            <source>the sound card takes no sound any more, and does not within {card_timeout} s; check it, and try again</source>
            <translation>Die Soundkarte nimmt seit {card_timeout} s keine Daten mehr an; prüfen und erneut versuchen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>The sound is {db} dB above the background noise, which is loud ({noise} dBFS); {least} dB or more are needed. Reduce the noise or move closer to the microphone, and say it again.</source>
            <translation>Der Laut liegt {db} dB über dem Hintergrundgeräusch, das laut ist ({noise} dBFS); nötig sind mindestens {least} dB. Das Geräusch verringern oder näher ans Mikrofon gehen und noch einmal sprechen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>The sound is {db} dB above the background noise; {least} dB or more are needed. Say it again, louder or closer to the microphone.</source>
            <translation>Der Laut liegt {db} dB über dem Hintergrundgeräusch; nötig sind mindestens {least} dB. Noch einmal sprechen, lauter oder näher am Mikrofon.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>The sound lasted only {seconds} s; {least} s or more are needed. Say it again and hold it.</source>
            <translation>Der Laut dauerte nur {seconds} s; nötig sind mindestens {least} s. Noch einmal sprechen und halten.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>The sound reached only {db} dBFS; {least} dBFS or more are needed. Say it again, louder or closer, or turn the microphone's level up.</source>
            <translation>Der Laut erreichte nur {db} dBFS; nötig sind mindestens {least} dBFS. Noch einmal sprechen, lauter oder näher, oder den Mikrofonpegel erhöhen.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/presets/model_choice.py" />
            <source>the speech encoder is not installed; {without_encoder}</source>
            <translation>Der Sprach-Encoder ist nicht installiert; {without_encoder}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>the speech encoder needs onnxruntime, which is not installed; install phonemeanalyser[encoder]</source>
            <translation>Der Sprach-Encoder benötigt onnxruntime, das nicht installiert ist; phonemeanalyser[encoder] installieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/output.py" />
            <source>the speed</source>
            <translation>das Tempo</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/recognition/templates.py" />
            <source>the spread must be above 0 in each of its numbers, got {self}; correct it</source>
            <translation>Jede Zahl der Streuung muss über 0 liegen, gefunden {self}; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>The strongest adaptation was rejected, because with it {cost}; a weaker one was chosen.</source>
            <translation>Die stärkste Anpassung wurde verworfen: {cost}; stattdessen wurde eine schwächere gewählt.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>The strongest adaptation was rejected, because with it {cost}; the preset stays unchanged.</source>
            <translation>Die stärkste Anpassung wurde verworfen: {cost}; das Preset bleibt unverändert.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/performance_model.py" />
            <source>The style is fitted to {n:.0f} s: it differs by {after:.3f} RMS, neutral by {before:.3f}.</source>
            <translation>Stil an {n:.0f} s angepasst: Abweichung {after:.3f} RMS, neutral {before:.3f}.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/face_mapping.py" />
            <source>the table {name} moves {unknown}, which is none of {basis}; choose another table</source>
            <translation>Die Tabelle {name} bewegt {unknown}, das gehört nicht zu {basis}; eine andere Tabelle wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_model.py" />
            <source>The take is too short ({seconds:.2f} s). Hold {phoneme} for as long as you say the sound.</source>
            <translation>Der Take ist zu kurz ({seconds:.2f} s). {phoneme} halten, solange der Laut gesprochen wird.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/written_text.py" />
            <source>The text has changed since these words were aligned. Align again.</source>
            <translation>Der Text wurde seit dem Ausrichten dieser Wörter geändert. Neu ausrichten.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/written_text.py" />
            <source>The text has changed since these words were spoken. Speak again.</source>
            <translation>Der Text wurde geändert, seit diese Wörter gesprochen wurden. Erneut sprechen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/rendering/materials.py" />
            <source>the texture {name} cannot be read ({reason}); export it again</source>
            <translation>Die Textur {name} ist nicht lesbar ({reason}); neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/workbench/labelled_features.py" />
            <source>the variable {variable} was not measured in these recordings; add it to the preset and have them measured anew</source>
            <translation>Die Variable {variable} wurde in diesen Aufnahmen nicht gemessen; zum Preset hinzufügen und die Aufnahmen neu messen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>The views are frozen while playback or the microphone goes on; click or press F to resume</source>
            <translation>Die Ansichten sind eingefroren, während Wiedergabe oder Mikrofon weiterlaufen; Klick oder F setzt sie fort</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/visemes.py" />
            <source>the viseme set has no viseme for the phoneme {lacking}; name one</source>
            <translation>Der Visemsatz hat kein Visem für das Phonem {lacking}; eins angeben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/visemes.py" />
            <source>the viseme set names {strange}, which is none of its visemes; add it to them</source>
            <translation>Der Visemsatz nennt {strange}, das keins seiner Viseme ist; hinzufügen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/speech/voice.py" />
            <source>the voice has no sounds for this text; check its language</source>
            <translation>Die Sprechstimme hat keine Laute für diesen Text; seine Sprache prüfen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/pronunciation.py" />
            <source>the voice of {tag} cannot read {spelt}, which is of another script; name the language of the text</source>
            <translation>Die Sprechstimme für {tag} kann {spelt} nicht lesen, da es in anderer Schrift steht; die Sprache des Textes angeben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/pronunciation.py" />
            <source>the voice of {tag} has no sounds for this text; check its language</source>
            <translation>die Sprechstimme für {tag} hat keine Laute für diesen Text; seine Sprache prüfen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/recording.py" />
            <source>the weights of a recording do not fit its frames</source>
            <translation>die Gewichte einer Aufnahme passen nicht zu ihren Frames</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/dsp/sonagram.py" />
            <source>the window</source>
            <translation>das Fenster</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/rendering/renderer.py" />
            <source>the window's OpenGL cannot be used ({error}); update the graphics driver</source>
            <translation>Das OpenGL des Fensters ist nicht benutzbar ({error}); Grafiktreiber aktualisieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/recording.py" />
            <source>the words of its clips are missing</source>
            <translation>die Wörter ihrer Clips fehlen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/expression/felt.py" />
            <source>the {name} follow a feeling by 0..1, found {amount}; correct it</source>
            <translation>{name} folgt einem Gefühl mit 0..1, gefunden: {amount}; berichtigen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Theatrical</source>
            <translation>Theatralisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Theme</source>
            <translation>Farbschema</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>There are no custom variables yet. Mark a range in the averaged spectrum first.</source>
            <translation>Es gibt noch keine eigenen Variablen. Zuerst einen Bereich im gemittelten Spektrum markieren.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/page.py" />
            <source>There are no deleted takes.</source>
            <translation>Es gibt keine gelöschten Takes.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>There are no errors to go to, since no tier is compared with the recognised phonemes. Load labels with Labels &gt; Load Labels, or choose a tier with Labels &gt; Tiers.</source>
            <translation>Es gibt keine Fehler anzusteuern, da keine Ebene mit den erkannten Phonemen verglichen wird. Beschriftungen laden (Beschriftungen &gt; Beschriftungen laden) oder eine Ebene wählen (Beschriftungen &gt; Ebenen).</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>There are no labels to save. Select a segment and press Ctrl+I to label it.</source>
            <translation>Es gibt keine Beschriftungen zu speichern. Einen Abschnitt auswählen und mit Strg+I beschriften.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>There are no labels yet. Open a sound with a label file beside it, record takes, load labelled recordings on Calibrate, or choose Add &gt; Folder.</source>
            <translation>Noch keine Beschriftungen. Eine Audiodatei mit Beschriftungsdatei öffnen, Takes aufnehmen, unter Kalibrieren beschriftete Aufnahmen laden oder Hinzufügen &gt; Ordner wählen.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/exports/gltf.py" />
            <source>there are no morph targets in it; put them into one file first, with: phonemeanalyser movestates export {path} TARGET... -o face.glb</source>
            <translation>Keine Morph-Targets enthalten; zuerst in einer Datei zusammenfassen mit: phonemeanalyser movestates export {path} TARGET... -o face.glb</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/performance_model.py" />
            <source>There are no recorded faces to fit the style to; open a table in Voice &amp; Face.</source>
            <translation>Es gibt keine aufgezeichneten Gesichter, an die der Stil angepasst werden kann; Tabelle unter Stimme &amp; Gesicht öffnen.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/containers.py" />
            <source>there are no samples in it</source>
            <translation>keine Samples enthalten</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/calibrate.py" />
            <source>there are no takes to calibrate with; record some first</source>
            <translation>es gibt keine Takes zum Kalibrieren; zuerst welche aufnehmen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_model.py" />
            <source>There are no takes to write labels for. Record one first.</source>
            <translation>Es gibt keine Takes, für die Beschriftungen geschrieben werden könnten. Zuerst einen aufnehmen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>There are no tiers yet. Load labels with Labels &gt; Load Labels.</source>
            <translation>Es gibt noch keine Ebenen. Beschriftungen laden mit Beschriftungen &gt; Beschriftungen laden.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/sound_words.py" />
            <source>There are no words to save; open an audio file and align its text first.</source>
            <translation>Keine Wörter zu speichern; zuerst eine Audiodatei öffnen und ihren Text ausrichten.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/movestate.py" />
            <source>there are two movestates {twice}; rename one</source>
            <translation>Es gibt zwei Blendshapes {twice}; einen umbenennen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/utterance_edits.py" />
            <source>there are {at} phones, found {k}; choose 0..{at_2}</source>
            <translation>es gibt {at} Phone, gefunden {k}; 0..{at_2} wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/files.py" />
            <source>there are {n} channels here and so no channel {number}; choose another</source>
            <translation>es gibt {n} Kanäle und keinen Kanal {number}; einen anderen wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/utterance.py" />
            <source>there are {spans} {unit}s, found boundary {boundary}; choose 0..{len}</source>
            <translation>{unit}: {spans} vorhanden, gefunden Grenze {boundary}; 0..{len} wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/storage/files.py" />
            <source>there is a file in the archive that is no array</source>
            <translation>im Archiv liegt eine Datei, die kein Array ist</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>There is a sound of {db} dBFS in the silence, whose background noise is at {noise} dBFS. Keep quiet and record it again.</source>
            <translation>In der Stille ist ein Geräusch von {db} dBFS, das Hintergrundgeräusch liegt bei {noise} dBFS. Nicht sprechen und noch einmal aufnehmen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>There is no averaged spectrum to export yet. Add one to the table first.</source>
            <translation>Noch kein gemitteltes Spektrum zum Exportieren. Zuerst in der Tabelle eines hinzufügen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>There is no averaged spectrum yet. Play a sound, or add one to the table first.</source>
            <translation>Noch kein gemitteltes Spektrum. Zuerst eine Datei abspielen oder in der Tabelle eines hinzufügen.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/speech/pinyin/track.py" />
            <source>there is no Chinese syllable in the text; write some, or choose another driver</source>
            <translation>Keine chinesische Silbe im Text; welche eingeben oder andere Steuerung wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/headers.py" />
            <source>there is no chunk with samples</source>
            <translation>kein Block mit Samples vorhanden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_model.py" />
            <source>There is no data to search. Record takes or load labelled recordings first.</source>
            <translation>Es gibt noch keine Daten zum Durchsuchen. Zuerst Takes aufnehmen oder beschriftete Aufnahmen laden.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/expression/streams.py" />
            <source>there is no expression {name}; {known}</source>
            <translation>Kein Ausdruck {name} vorhanden; {known}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/exports/exporter.py" />
            <source>there is no format {name}; {formats}</source>
            <translation>Kein Format {name} vorhanden; {formats}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/conversion/work.py" />
            <source>there is no kind of file {kind}; {conversions}</source>
            <translation>Keine Dateiart {kind} vorhanden; {conversions}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/scores/corpus.py" />
            <source>there is no label file beside this sound</source>
            <translation>Keine Beschriftungsdatei neben dieser Audiodatei</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/label_tiers.py" />
            <source>There is no label to split at the cursor. Click into one below the sonagram first.</source>
            <translation>Am Cursor ist keine Beschriftung, die sich teilen lässt. Zuerst in eine unter dem Sonagramm klicken.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/scores/evaluation.py" />
            <source>there is no labelled sound that can be scored; name recordings that can be read</source>
            <translation>Keine auswertbare Audiodatei mit Beschriftungen; lesbare Aufnahmen angeben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf.py" />
            <source>there is no mesh in it; export one with it</source>
            <translation>Kein Mesh enthalten; mit Mesh exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/movestate.py" />
            <source>there is no movestate {name}; choose one of {self}</source>
            <translation>Kein Blendshape {name} vorhanden; einen davon wählen: {self}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/sound_words.py" />
            <source>There is no pause at the cursor for another word. Go to a pause, or split a word.</source>
            <translation>Am Cursor ist keine Pause für ein weiteres Wort. Zu einer Pause gehen oder ein Wort teilen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/preset.py" />
            <source>There is no preset B yet. Open the list of presets and set one as B.</source>
            <translation>Es gibt noch kein Preset B. In der Liste der Presets eines als B festlegen.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/recognition/spec.py" />
            <source>there is no recogniser named {name}; known are {recogniser_names}; install the package that brings it, or choose another preset</source>
            <translation>Kein Erkenner namens {name} vorhanden; bekannt sind {recogniser_names}; zugehöriges Paket installieren oder anderes Preset wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/table_file.py" />
            <source>there is no recording of the number {number}</source>
            <translation>keine Aufnahme mit der Nummer {number}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/takes/sentences.py" />
            <source>there is no sentence in {language}; {languages}</source>
            <translation>Kein Satz in {language} vorhanden; {languages}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/face_mapping.py" />
            <source>there is no set of movestates {basis}; {enough}</source>
            <translation>Es gibt keinen Satz von Movestates {basis}; {enough}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/live/player.py" />
            <source>there is no sound card to play on; connect one</source>
            <translation>Keine Soundkarte für die Wiedergabe; eine anschließen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/inspection/measurement.py" />
            <source>there is no sound from {start} to {end} s; choose a segment within the sound</source>
            <translation>Kein Audio von {start} bis {end} s; ein Segment innerhalb der Audiodatei wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/containers.py" />
            <source>there is no sound in it</source>
            <translation>kein Ton enthalten</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/storage/files.py" />
            <source>there is no such file; check its name and folder</source>
            <translation>Diese Datei gibt es nicht; Name und Ordner prüfen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/choice.py" />
            <source>there is no such table {use}, but {names}; choose another one with --use</source>
            <translation>Es gibt keine Tabelle {use}, aber {names}; mit --use eine andere wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/speech/pinyin/track.py" />
            <source>there is no syllable of pinyin in what is said; choose another driver</source>
            <translation>Keine Pinyin-Silbe im Gesprochenen; andere Steuerung wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/choice.py" />
            <source>there is no table of {asked}, as none says who speaks in it; leave --person out</source>
            <translation>Es gibt keine Tabelle von {asked}, da in keiner steht, wer darin spricht; --person weglassen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/choice.py" />
            <source>there is no table of {asked}, but of {persons}; choose another one with --person</source>
            <translation>Es gibt keine Tabelle von {asked}, aber von {persons}; mit --person eine andere wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/shipping/targets.py" />
            <source>there is no target {target}; {targets}</source>
            <translation>Kein Ziel {target} vorhanden; {targets}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>There is no text; type it into the field below the head.</source>
            <translation>Kein Text vorhanden; den Text in das Feld unter dem Kopf eingeben.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/espeak.py" />
            <source>there is no voice {name}; choose one such as f2, f5, m3, m7 or klatt, of {known}</source>
            <translation>Keine Sprechstimme {name} vorhanden; eine wählen wie f2, f5, m3, m7 oder klatt, von {known}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/fits/fitting.py" />
            <source>there is no voiced sound of {name}; record vowels or a sentence</source>
            <translation>von {name} gibt es keinen stimmhaften Laut; Vokale oder einen Satz aufnehmen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/encoder/model_folder.py" />
            <source>there is no Whisper model; {how_to_get}</source>
            <translation>Kein Whisper-Modell vorhanden; {how_to_get}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/alignment/aligner.py" />
            <source>there is no word in the text; write down what is said in the sound</source>
            <translation>im Text steht kein Wort; aufschreiben, was in der Aufnahme gesagt wird</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/cleaning.py" />
            <source>there is no word to speak in {text}; write some</source>
            <translation>in {text} steht kein Wort zum Sprechen; etwas schreiben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/timed_words.py" />
            <source>there is no {speaker}</source>
            <translation>Kein Sprecher {speaker}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/speech/silent.py" />
            <source>there is no {what} in the text; write some, or name its language</source>
            <translation>Im Text fehlt: {what}; etwas eingeben oder seine Sprache angeben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/fits/fitting.py" />
            <source>there is nothing to fit to; load recordings with labelled phonemes</source>
            <translation>es gibt nichts, woran angepasst werden könnte; Aufnahmen mit beschrifteten Phonemen laden</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/calibrate.py" />
            <source>there is nothing to measure the result on; give takes or recordings whose labels are certain</source>
            <translation>es gibt nichts, woran sich das Ergebnis messen lässt; Takes oder Aufnahmen mit sicherer Beschriftung verwenden</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/recognition/templates.py" />
            <source>there must be at least one template, and there is none; record takes of the phonemes</source>
            <translation>Mindestens eine Vorlage ist nötig, vorhanden ist keine; Takes der Phoneme aufnehmen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/page.py" />
            <source>These labels are not known phoneme names. Choose a phoneme for each one; labels left unidentified are not scored.</source>
            <translation>Diese Beschriftungen sind keine bekannten Phonemnamen. Für jede ein Phonem wählen; was unbekannt bleibt, wird nicht bewertet.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>These labels have several speakers; choose one beside the text.</source>
            <translation>Diese Beschriftungen haben mehrere Sprecher; einen neben dem Text wählen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Third formant</source>
            <translation>Dritter Formant</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/x_file.py" />
            <source>this .x file is of the kind {kind}, and only text can be read; save it as text</source>
            <translation>Diese .x-Datei ist von der Art {kind}, lesbar ist nur Text; als Text speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/curves.py" />
            <source>This average is in the table already, as {name}</source>
            <translation>Dieses Spektrum steht schon in der Tabelle, als {name}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/serve_dialog.py" />
            <source>This computer only (127.0.0.1)</source>
            <translation>Nur dieser Rechner (127.0.0.1)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>This File</source>
            <translation>Diese Datei</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>This file: {name}</source>
            <translation>Diese Datei: {name}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/storage/files.py" />
            <source>this is a folder; choose a file in it</source>
            <translation>Dies ist ein Ordner; eine Datei darin wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>this is no glTF: its JSON cannot be read; choose another file</source>
            <translation>Kein glTF: Das JSON ist nicht lesbar; andere Datei wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf_document.py" />
            <source>this is no glTF: its JSON is no table; choose another file</source>
            <translation>Kein glTF: Das JSON ist keine Tabelle; andere Datei wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/curves_file.py" />
            <source>this is no JSON ({cause}); export the curves again</source>
            <translation>Kein JSON ({cause}); Kurven neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/storage/strict_table.py" />
            <source>this is no TOML file ({cause}); correct it there</source>
            <translation>Keine TOML-Datei ({cause}); dort korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/gltf.py" />
            <source>this is no VRM, it tells of no bones and expressions; rename it to .glb, or choose another</source>
            <translation>Kein VRM: Knochen und Ausdrücke fehlen; in .glb umbenennen oder eine andere Datei wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/encoder/live.py" />
            <source>this is not a real-time model, or it is damaged; download it again</source>
            <translation>Kein Echtzeitmodell oder beschädigt; neu herunterladen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>this kind of file</source>
            <translation>Diese Dateiart</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>this preset was trained without this model; choose another preset, such as Learned</source>
            <translation>dieses Preset wurde ohne dieses Modell trainiert; ein anderes Preset wählen, etwa Learned</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/shipping/sections.py" />
            <source>this preset's model recognises files only, the runtime live sound only; choose another preset</source>
            <translation>Das Modell dieses Presets erkennt nur Dateien, die Laufzeitbibliothek nur in Echtzeit; anderes Preset wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/encoder/live.py" />
            <source>this real-time model is of a newer version; update the program</source>
            <translation>Dieses Echtzeitmodell hat eine neuere Version; Programm aktualisieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/inspection/measurement.py" />
            <source>this segment is still being analysed; measure it in a moment</source>
            <translation>dieser Abschnitt wird noch analysiert; gleich noch einmal messen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/table_file.py" />
            <source>this table of performances has version {version}, and this program knows those up to {version_2}; install a newer one, or build the table anew</source>
            <translation>Diese Tabelle von Gesichtsaufnahmen hat Version {version}, bekannt ist bis {version_2}; Programm aktualisieren oder Tabelle neu erstellen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>This takes a few seconds</source>
            <translation>Das dauert einige Sekunden</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/shipping/compiling.py" />
            <source>this target is compiled by zig, which is not installed; install zig, or pip install 'phonemeanalyser[ship]', or ship the target c</source>
            <translation>Dieses Ziel wird mit zig kompiliert, das nicht installiert ist; zig installieren, pip install 'phonemeanalyser[ship]' ausführen oder das Ziel c wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/threshold_view.py" />
            <source>Thresholds</source>
            <translation>Schwellen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Tier Above</source>
            <translation>Ebene darüber</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Tier Below</source>
            <translation>Ebene darunter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Tier to compare with the recognised phonemes</source>
            <translation>Ebene, die mit den erkannten Phonemen verglichen wird</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Tiers</source>
            <translation>Ebenen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Tiers…</source>
            <translation>Ebenen…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>time (s)</source>
            <translation>Zeit (s)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/scroll_view.py" />
            <source>Time before now (s)</source>
            <translation>Zeit vor jetzt (s)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Time by which the mouth moves before the speech is audible</source>
            <translation>Zeit, um die sich der Mund bewegt, bevor die Sprache zu hören ist</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/frame_views.py" />
            <source>Time in the window</source>
            <translation>Zeit im Fenster</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>Time smoothing</source>
            <translation>Zeitglättung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>Time, and number of the picture, counted from 0</source>
            <translation>Zeit und Nummer des Bildes, ab 0 gezählt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Timeline</source>
            <translation>Zeitleiste</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/time_line.py" />
            <source>Timeline: words and phones over time</source>
            <translation>Zeitleiste: Wörter und Phone über der Zeit</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/utterance.py" />
            <source>times must be seconds from 0</source>
            <translation>Zeiten müssen Sekunden ab 0 sein</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>To</source>
            <translation>Bis</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/sonagram.py" />
            <source>to</source>
            <translation>bis</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>to </source>
            <translation>bis </translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/serve_dialog.py" />
            <source>Token</source>
            <translation>Token</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/sources.py" />
            <source>Tone</source>
            <translation>Ton</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>too high</source>
            <translation>zu hoch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>Too many open files</source>
            <translation>Zu viele offene Dateien</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/morph_mesh.py" />
            <source>too many vertices are within {distance} of each other; choose a smaller tolerance</source>
            <translation>Zu viele Eckpunkte liegen näher als {distance} beieinander; kleinere Toleranz wählen</translation>
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
            <source>total energy</source>
            <translation>Gesamtenergie</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Totontepec Mixe</source>
            <translation>Totontepec-Mixe</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Tour of Talk</source>
            <translation>Tour durch Sprechen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Transparent (GIF, PNG)</source>
            <translation>Transparent (GIF, PNG)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/window.py" />
            <source>Transport</source>
            <translation>Wiedergabe</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Trim take</source>
            <translation>Take zuschneiden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>trim {take}</source>
            <translation>Zuschneiden von {take}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>true or false</source>
            <translation>true oder false</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/mapping_dialog.py" />
            <source>Try</source>
            <translation>Testen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Try Again</source>
            <translation>Noch einmal</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/mapping_dialog.py" />
            <source>Try {name}</source>
            <translation>{name} testen</translation>
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
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_editor.py" />
            <source>Turn them into rules of your own that recognise the same</source>
            <translation>In eigene Regeln umwandeln, die dasselbe erkennen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/speech/pinyin/table.py" />
            <source>two letters that [shapes] has</source>
            <translation>zwei Buchstaben aus [shapes]</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/animation.py" />
            <source>two movements can be compared if both have frames, the same frame rate and movestates in common; make both with the same options</source>
            <translation>zwei Bewegungen lassen sich vergleichen, wenn beide Frames, dieselbe Bildrate und gemeinsame Movestates haben; beide mit denselben Optionen erzeugen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/morph_mesh.py" />
            <source>two movestates are called {twice}; rename one</source>
            <translation>Zwei Blendshapes heißen {twice}; einen umbenennen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/presets/preset.py" />
            <source>two shares 0..1, before and after</source>
            <translation>zwei Anteile 0..1, vorher und nachher</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/threshold_view.py" />
            <source>Type a number, or press the arrow keys.</source>
            <translation>Zahl eingeben oder Pfeiltasten drücken.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Ukrainian</source>
            <translation>Ukrainisch</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>unable to open database file</source>
            <translation>Datenbank lässt sich nicht öffnen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>Unclosed array</source>
            <translation>Nicht abgeschlossene Liste</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Undo all changes to the style since it was saved</source>
            <translation>Alle Änderungen am Stil seit dem Speichern zurücknehmen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>unidentified</source>
            <translation>unbekannt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>unit</source>
            <translation>Einheit</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Unit selection</source>
            <translation>Auswahl der Einheiten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/spoken_lanes.py" />
            <source>Units</source>
            <translation>Einheiten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Unity package: C#, a talking face and a talking sprite</source>
            <translation>Unity-Paket: C#, ein sprechendes Gesicht und ein sprechendes Sprite</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/page.py" />
            <source>Unknown Labels</source>
            <translation>Unbekannte Beschriftungen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Unload all labelled recordings; their files are kept</source>
            <translation>Alle beschrifteten Aufnahmen entladen; die Dateien bleiben erhalten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Unreal plugin: C++, a talking face and Live Link</source>
            <translation>Unreal-Plugin: C++, ein sprechendes Gesicht und Live Link</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Unsaved Boundaries</source>
            <translation>Ungespeicherte Grenzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/preset_dialogs.py" />
            <source>Unsaved Changes</source>
            <translation>Ungespeicherte Änderungen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/preset_choice.py" />
            <source>unsaved changes</source>
            <translation>ungespeicherte Änderungen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/unsaved.py" />
            <source>Unsaved changes can't be kept for the next start: {error}</source>
            <translation>Ungespeicherte Änderungen können nicht für den nächsten Start behalten werden: {error}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/preset_dialogs.py" />
            <source>Unsaved changes from the last session cannot be restored: {error}</source>
            <translation>Ungespeicherte Änderungen aus der letzten Sitzung lassen sich nicht wiederherstellen: {error}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/preset_dialogs.py" />
            <source>Unsaved changes to the preset {name} were restored from the last session.</source>
            <translation>Ungespeicherte Änderungen am Preset {name} aus der letzten Sitzung wurden wiederhergestellt.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Unsaved Keys</source>
            <translation>Ungespeicherte Keyframes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Unsaved Labels</source>
            <translation>Ungespeicherte Beschriftungen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/dialogs.py" />
            <source>Unsaved Text</source>
            <translation>Nicht gespeicherter Text</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>Unterminated string</source>
            <translation>Nicht abgeschlossener Text</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>Unterminated string starting at</source>
            <translation>Nicht abgeschlossener Text</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Up, Down</source>
            <translation>Auf, Ab</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/sonagram.py" />
            <source>Upper edge of the sonagram</source>
            <translation>Oberer Rand des Sonagramms</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Use and Save As…</source>
            <translation>Verwenden und speichern…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Use as Take of</source>
            <translation>Als Take verwenden für</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>Use Default Microphone if Disconnected</source>
            <translation>Bei Verbindungsverlust Standardmikrofon nutzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/rule_dialogs.py" />
            <source>Use in a Rule</source>
            <translation>In einer Regel verwenden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>Use in a Rule…</source>
            <translation>In einer Regel verwenden…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/welcome.py" />
            <source>Use My Microphone</source>
            <translation>Mikrofon verwenden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Use New Preset</source>
            <translation>Neues Preset verwenden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Use the Better One</source>
            <translation>Das bessere verwenden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Use the new preset and save it under a new name</source>
            <translation>Neues Preset verwenden und unter neuem Namen speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Use the new preset; Ctrl+Z restores the old one (Return)</source>
            <translation>Neues Preset verwenden; Strg+Z stellt das alte wieder her (Eingabetaste)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Use the other one of A and B</source>
            <translation>Das andere von A und B verwenden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Use the preset with the higher macro F1 from now on</source>
            <translation>Das Preset mit dem höheren Makro-F1 ab jetzt verwenden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>Use {letter}: {preset}</source>
            <translation>{letter} verwenden: {preset}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/rules.py" />
            <source>use {variable} in a rule for {phoneme}</source>
            <translation>{variable} in einer Regel für {phoneme} verwenden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/preset_dialogs.py" />
            <source>User</source>
            <translation>Eigene</translation>
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
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Value</source>
            <translation>Wert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>Variable</source>
            <translation>Variable</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>Variable whose course is drawn. Type to search; sorted by how well it separates the two phonemes.</source>
            <translation>Variable, deren Verlauf gezeichnet wird. Tippen sucht; sortiert danach, wie gut sie die beiden Phoneme trennt.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>Variable:</source>
            <translation>Variable:</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/variables_panel.py" />
            <source>Variables</source>
            <translation>Variablen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>Variables of the preset</source>
            <translation>Variablen des Presets</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>Variables or PhonemeData</source>
            <translation>Variablen oder PhonemeData</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Vary mouth shapes and times slightly, as people do</source>
            <translation>Mundformen und Zeiten leicht variieren, wie bei Menschen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>vertex</source>
            <translation>Eckpunkt</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/mesh.py" />
            <source>vertex {first} has no finite position ({points}); export it again</source>
            <translation>Eckpunkt {first} hat keine endliche Position ({points}); neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/exports.py" />
            <source>video of the head with its sound</source>
            <translation>Video des Kopfes mit Ton</translation>
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
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>View</source>
            <translation>Ausschnitt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>Views are frozen</source>
            <translation>Ansichten eingefroren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>Visible tiers</source>
            <translation>Sichtbare Ebenen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Voice</source>
            <translation>Sprechstimme</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Voice &amp;&amp; Face…</source>
            <translation>Stimme &amp;&amp; Gesicht…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Voice that speaks the text: one of espeak-ng, the recordings of the table in use, or an external text-to-speech program</source>
            <translation>Stimme, die den Text spricht: eine von espeak-ng, die Aufnahmen der benutzten Tabelle oder ein externes Sprachprogramm</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Voice, speech rate, and driver of the mouth</source>
            <translation>Stimme, Sprechtempo und Steuerung des Mundes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Volume</source>
            <translation>Lautstärke</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>volume (peak level)</source>
            <translation>Lautstärke (Spitzenpegel)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/phoneme_view.py" />
            <source>Volume: peak level in the current window of 46.4 ms, full scale 1</source>
            <translation>Lautstärke: Spitzenpegel im aktuellen Fenster von 46.4 ms, Vollaussteuerung 1</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
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
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>Vowels</source>
            <translation>Vokale</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>vowels</source>
            <translation>Vokale</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>waiting</source>
            <translation>wartet</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>waiting for a signal from {microphone}</source>
            <translation>warten auf ein Signal von {microphone}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/expression_model.py" />
            <source>Waiting for messages</source>
            <translation>Wartet auf Nachrichten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/welcome.py" />
            <source>Watch the Demo</source>
            <translation>Demo ansehen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>WAV (RF64 beyond 4 GB)</source>
            <translation>WAV (RF64 über 4 GB)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/frame_views.py" />
            <source>Waveform</source>
            <translation>Wellenform</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/transport.py" />
            <source>Waveform of the whole file in the colours of its phonemes (grey: not analysed yet). Click to go to that time; arrow keys move by 1 s</source>
            <translation>Wellenform der ganzen Datei in den Farben ihrer Phoneme (grau: noch nicht analysiert). Klick: zu dieser Stelle gehen; Pfeiltasten: um 1 s</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/frame_views.py" />
            <source>Waveform: display gain</source>
            <translation>Wellenform: Anzeigeverstärkung</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>WebAssembly and AudioWorklet, with a page that shows a talking head</source>
            <translation>WebAssembly und AudioWorklet, mit einer Seite, die einen sprechenden Kopf zeigt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Weight of the mouth shape {shape}</source>
            <translation>Gewicht der Mundform {shape}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>Weight of the mouth shape {shape}; with all weights at 0, speech alone moves the mouth</source>
            <translation>Gewicht der Mundform {shape}; sind alle Gewichte 0, bewegt allein die Sprache den Mund</translation>
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
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/phoneme_view.py" />
            <source>What each rule compared in the current frame, down to the one that fired: value, limit, and the margin by which the comparison held (✓) or failed (✗)</source>
            <translation>Was jede Regel im aktuellen Frame verglich, bis zu der, die zutraf: Wert, Grenze und der Abstand, um den der Vergleich galt (✓) oder nicht galt (✗)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>What happened to the file on disk</source>
            <translation>Was mit der Datei auf der Platte geschah</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>What happens to the speech, the other mouth shapes and blinks while a slider is above 0: they stay, and all movements add up; all but blinks go to 0; blinks go to 0, too; or first the speech, then the other shapes are reduced until the sum is 100 % at most. Keys and buttons set everything but blinks to 0 while they are held</source>
            <translation>Was mit der Sprache, den anderen Mundformen und dem Blinzeln geschieht, solange ein Regler über 0 steht: Sie bleiben, und alle Bewegungen addieren sich; alles außer dem Blinzeln geht auf 0; auch das Blinzeln geht auf 0; oder erst die Sprache, dann die anderen Formen werden verringert, bis die Summe höchstens 100 % ist. Tasten und Schaltflächen setzen alles außer dem Blinzeln auf 0, solange sie gehalten werden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>What is behind the head; videos cannot be transparent</source>
            <translation>Was hinter dem Kopf ist; Videos können nicht transparent sein</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>What Is This?</source>
            <translation>Was ist das?</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>What moves the mouth</source>
            <translation>Was den Mund steuert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>What moves the mouth: recorded faces and pinyin letters where the words are known, a network by any sound. Automatic: recorded faces or a network if one is open, pinyin letters for Chinese, else phonemes</source>
            <translation>Was den Mund steuert: aufgezeichnete Gesichter und Pinyin-Buchstaben, wo die Wörter bekannt sind, ein Netz bei jedem Ton. Automatisch: aufgezeichnete Gesichter oder ein Netz, wenn geöffnet, Pinyin-Buchstaben für Chinesisch, sonst Phoneme</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>What rules may compare: frequency bands, with filters that suit them, or the preset's variables</source>
            <translation>Was Regeln vergleichen dürfen: Frequenzbänder, mit passenden Filtern, oder die Variablen des Presets</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/score_strip.py" />
            <source>What the figures are of: the visible part of the file, the whole file, or all takes and recordings loaded in Calibrate together with the open file</source>
            <translation>Wofür die Werte gelten: sichtbarer Teil der Datei, ganze Datei oder alle auf „Kalibrieren“ geladenen Takes und Aufnahmen mit der offenen Datei</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/spoken_lanes.py" />
            <source>What the text says of feeling. Double-click to change it (such as smile 0.6; nothing deletes it), or where there is none to add one; drag an end to move it. Edits are directions in the text.</source>
            <translation>Was der Text an Gefühl sagt. Doppelklicken, um es zu ändern (etwa smile 0.6; leer löscht es) oder, wo keines ist, eines hinzuzufügen; ein Ende ziehen, um es zu verschieben. Änderungen sind Regieanweisungen im Text.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_view.py" />
            <source>Wheel: zoom at the pointer. Drag: scroll. Click: go to that time. Shift+drag, or [ and ] at the cursor: select. Home, End: go to the start or end. Labels: type to rename, Enter splits at the cursor, drag a boundary (Ctrl: without snapping).</source>
            <translation>Mausrad: am Zeiger zoomen. Ziehen: verschieben. Klick: dorthin gehen. Umschalt+Ziehen oder [ und ] am Cursor: auswählen. Pos1, Ende: zum Anfang oder Ende. Beschriftungen: tippen benennt um, die Eingabetaste teilt am Cursor, Ziehen verschiebt eine Grenze (Strg: ohne Einrasten).</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/comparison.py" />
            <source>Where both heads differ most; choose a place to go there</source>
            <translation>Wo sich beide Köpfe am stärksten unterscheiden; eine Stelle wählen, um dorthin zu gehen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>where it begins</source>
            <translation>der Anfang</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>where it ends</source>
            <translation>das Ende</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Where poses overlap, the one with the higher priority comes first</source>
            <translation>Wo sich Posen überlagern, geht die mit der höheren Priorität vor</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>where tier {name} begins</source>
            <translation>der Anfang von Spur {name}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>where tier {name} ends</source>
            <translation>das Ende von Spur {name}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Where words and their times come from: recognition only, the Talk page, or files beside the audio files</source>
            <translation>Woher Wörter und ihre Zeiten kommen: nur Erkennung, Seite Sprechen oder Dateien neben den Audiodateien</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>Whether the curve is shown, its colour, and its name; F2 or a double click renames it</source>
            <translation>Ob die Kurve angezeigt wird, ihre Farbe und ihr Name; F2 oder Doppelklick benennt sie um</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/take_list.py" />
            <source>Whether the take is good enough for calibration</source>
            <translation>Ob der Take zum Kalibrieren gut genug ist</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/textgrid.py" />
            <source>whether there are tiers</source>
            <translation>die Angabe, ob es Spuren gibt,</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>Which poses or numbers of the style the table below shows; double-click one to edit it. Shape, width and firmness act on rules, too, priorities on recorded faces, where poses overlap</source>
            <translation>Welche Posen oder Zahlen des Stils die Tabelle zeigt; Doppelklick ändert eine. Form, Breite und Festigkeit wirken auch bei Regeln, Prioritäten bei aufgezeichneten Gesichtern, wo Posen überlappen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>Which recording is used where several have the same phones</source>
            <translation>Welche Aufnahme verwendet wird, wo mehrere dieselben Phone enthalten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Whisper base and network</source>
            <translation>Whisper base und Netz</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/encoder/model_folder.py" />
            <source>Whisper base cannot be fetched ({error}); see to the network, or name a folder</source>
            <translation>Whisper base lässt sich nicht laden ({error}); Netzwerk prüfen oder einen Ordner angeben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>Whisper base, multilingual, by OpenAI, MIT licence; {origin}: {path}</source>
            <translation>Whisper base, mehrsprachig, von OpenAI, MIT-Lizenz; {origin}: {path}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/encoder/whisper.py" />
            <source>Whisper needs {needed_memory} MB of memory and {free} MB are free; close other programs</source>
            <translation>Whisper braucht {needed_memory} MB Arbeitsspeicher, frei sind {free} MB; andere Programme schließen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>white noise</source>
            <translation>weißes Rauschen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/time_view.py" />
            <source>Whole recording</source>
            <translation>Ganze Aufnahme</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Width</source>
            <translation>Breite</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Width of the picture, pixels</source>
            <translation>Breite des Bildes in Pixeln</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/sonagram.py" />
            <source>Window</source>
            <translation>Fenster</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>window</source>
            <translation>Fenster</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Wireframe</source>
            <translation>Drahtgitter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/parts.py" />
            <source>Wireframe (W)</source>
            <translation>Drahtgitter (W)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/comparison.py" />
            <source>With a Face Network</source>
            <translation>Mit einem Gesichtsnetz</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/comparison.py" />
            <source>With Phonemes (Rules)</source>
            <translation>Mit Phonemen (Regeln)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/comparison.py" />
            <source>With Pinyin Letters</source>
            <translation>Mit Pinyin-Buchstaben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/comparison.py" />
            <source>With Preset B (Analysis &gt; Choose Preset B…)</source>
            <translation>Mit Preset B (Analyse &gt; Preset B wählen…)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/comparison.py" />
            <source>With Preset {preset}</source>
            <translation>Mit Preset {preset}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/comparison.py" />
            <source>With Recorded Faces</source>
            <translation>Mit aufgezeichneten Gesichtern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>Without frames of {sounds}, the variables are not sorted by separation.</source>
            <translation>Ohne Frames von {sounds} sind die Variablen nicht nach Trennung sortiert.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/face_model.py" />
            <source>Woman</source>
            <translation>Frau</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>word</source>
            <translation>Wort</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_choices.py" />
            <source>Word timing</source>
            <translation>Wortzeiten</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_layout.py" />
            <source>Words</source>
            <translation>Wörter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>words</source>
            <translation>Wörter</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/feelings.py" />
            <source>words are good or bad by -1..1, found {key}; correct it</source>
            <translation>Wörter sind gut oder schlecht mit -1..1, gefunden: {key}; berichtigen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/time_line.py" />
            <source>Words that fit the recording badly; choose one to play it</source>
            <translation>Wörter, die schlecht zur Aufnahme passen; eines wählen, um es abzuspielen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/sonagram.py" />
            <source>Words, if known (lanes below: words, syllables or letters, phones, units)</source>
            <translation>Wörter, falls bekannt (Spuren darunter: Wörter, Silben oder Buchstaben, Phone, Einheiten)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>Workbench tabs</source>
            <translation>Reiter der Werkbank</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Write Labels for Audacity (TXT)</source>
            <translation>Textmarken für Audacity schreiben (TXT)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>Write Labels for Praat (TextGrid)</source>
            <translation>Beschriftungen für Praat schreiben (TextGrid)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/preset_dialogs.py" />
            <source>Writing files for {target} to {folder}…</source>
            <translation>Dateien für {target} werden in {folder} geschrieben…</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>writing is no longer permitted</source>
            <translation>Schreiben ist nicht mehr erlaubt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>your share of the disk is used up</source>
            <translation>der eigene Speicherplatz ist aufgebraucht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>Your voice is now recognised better</source>
            <translation>Die Stimme wird jetzt besser erkannt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>zero crossings</source>
            <translation>Nulldurchgänge</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/phoneme_view.py" />
            <source>Zero crossings in the current window of 46.4 ms</source>
            <translation>Nulldurchgänge im aktuellen Fenster von 46.4 ms</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/help.py" />
            <source>Zoom in, zoom out</source>
            <translation>Vergrößern, verkleinern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Zoom to Entire File</source>
            <translation>Auf die ganze Datei zoomen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/commands.py" />
            <source>Zoom to Selection</source>
            <translation>Auf Auswahl zoomen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_view.py" />
            <source>Zoom to the selection (Shift+Z); Shift+drag selects</source>
            <translation>Auf die Auswahl zoomen (Umschalt+Z); Umschalt+Ziehen wählt aus</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_view.py" />
            <source>Zoom to the whole file (Shift+A)</source>
            <translation>Auf die ganze Datei zoomen (Umschalt+A)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/time_line.py" />
            <source>Zoom to the whole length</source>
            <translation>Auf die ganze Länge zoomen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{about}, its channels cancel each other out when mixed; channel {number} is inverted</source>
            <translation>{about}, Kanäle löschen sich beim Mischen aus; Kanal {number} invertiert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{about}, only channel {number} of {n} has a signal and is used</source>
            <translation>{about}, nur Kanal {number} von {n} hat ein Signal und wird verwendet</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{about}, only the channels {numbers} of {n} have a signal and are mixed</source>
            <translation>{about}, nur die Kanäle {numbers} von {n} haben ein Signal und werden gemischt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{about}, the recording peaks at {peak} dBFS; amplified by {gain} dB for recognition</source>
            <translation>{about}, Spitzenpegel {peak} dBFS; zur Erkennung um {gain} dB verstärkt</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/conversion/driving.py" />
            <source>{asked} {driver} needs a {what} of recorded faces; name it with {option}</source>
            <translation>{asked} {driver} braucht {what} aufgenommener Gesichter; mit {option} angeben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{cause} at {seconds} s of {sound}</source>
            <translation>{cause} bei {seconds} s von {sound}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/phoneme_view.py" />
            <source>{changes:.1f} changes/s</source>
            <translation>{changes:.1f} Wechsel/s</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/headers.py" />
            <source>{chunk} claims {size} bytes, {chunk_2} are there</source>
            <translation>{chunk} gibt {size} Byte an, vorhanden sind {chunk_2}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/serve_dialog.py" />
            <source>{client}: file exported</source>
            <translation>{client}: Datei exportiert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/serve_dialog.py" />
            <source>{client}: refused: {words}</source>
            <translation>{client}: abgelehnt: {words}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/serve_dialog.py" />
            <source>{client}: stream begun, {n} open</source>
            <translation>{client}: Stream begonnen, {n} offen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/serve_dialog.py" />
            <source>{client}: stream ended, {n} open</source>
            <translation>{client}: Stream beendet, {n} offen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>{clock} · picture {picture}</source>
            <translation>{clock} · Bild {picture}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{cost} in the real-time model</source>
            <translation>{cost} beim Echtzeitmodell</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{cost} in the small network</source>
            <translation>{cost} beim kleinen Netz</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/io.py" />
            <source>{error}, or rename a target's file</source>
            <translation>{error}, oder die Datei eines Targets umbenennen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/exports/gltf.py" />
            <source>{face}: it has no morph target of the table {name} ({wanted}, ...); choose a table for its names with --table, or name the targets in your modelling program</source>
            <translation>{face}: Kein Morph-Target der Tabelle {name} vorhanden ({wanted}, ...); passende Tabelle wählen (--table) oder die Targets im Modellierprogramm umbenennen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>{file} has changed on disk since it was opened; click to reload it</source>
            <translation>{file} wurde seit dem Öffnen auf dem Datenträger geändert; zum Neuladen klicken</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_model.py" />
            <source>{file} has changed on the disk; its words are taken from the files beside it again.</source>
            <translation>{file} wurde auf dem Datenträger geändert; die Wörter werden erneut aus den Dateien daneben gelesen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/dialogs.py" />
            <source>{file} was moved or deleted; its analysis stays on screen</source>
            <translation>{file} wurde verschoben oder gelöscht; die Analyse bleibt sichtbar</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/phone_sets.py" />
            <source>{file}, line {line}: {row} stands there twice; remove one of the rows</source>
            <translation>{file}, Zeile {line}: {row} steht zweimal da; eine der Zeilen entfernen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/textgrid.py" />
            <source>{file}, line {line}: {what} must be {expected}, found {found}; the file is cut off or damaged, so save it in Praat again</source>
            <translation>{file}, Zeile {line}: {what} muss {expected} sein, gefunden {found}; die Datei ist abgeschnitten oder beschädigt, daher in Praat neu speichern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>{file}, line {number}</source>
            <translation>{file}, Zeile {number}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>{file}, row {number}</source>
            <translation>{file}, Zeile {number}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/audacity.py" />
            <source>{file}, {place}: a label of Audacity is start, end and name with tabs between them, found {line}; export the label track again</source>
            <translation>{file}, {place}: Eine Beschriftung von Audacity besteht aus Anfang, Ende und Name mit Tabulatoren dazwischen, gefunden {line}; Textspur neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/lexicon.py" />
            <source>{file}, {place}: a lexicon has single words, found {word}; correct it</source>
            <translation>{file}, {place}: Ein Lexikon enthält einzelne Wörter, gefunden {word}; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/utterance.py" />
            <source>{file}, {place}: labels must not overlap, found {following} after {raw} of {place_2}; move one of their borders</source>
            <translation>{file}, {place}: Beschriftungen dürfen sich nicht überlappen, gefunden {following} nach {raw} in {place_2}; eine Grenze verschieben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/table.py" />
            <source>{file}, {place}: start_s and end_s must be seconds, found {row} and {row_2}; correct the row</source>
            <translation>{file}, {place}: start_s und end_s müssen Sekunden sein, gefunden {row} und {row_2}; Zeile korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/table.py" />
            <source>{file}, {place}: the class must be a phoneme, found nothing; fill the cell in</source>
            <translation>{file}, {place}: Die Klasse muss ein Phonem sein, die Zelle ist leer; ausfüllen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/utterance.py" />
            <source>{file}, {place}: the label at {raw} lies beyond the end of the sound, which lasts {duration} s; check whether the labels belong to this sound</source>
            <translation>{file}, {place}: Die Beschriftung bei {raw} liegt hinter dem Ende der Audiodatei, die {duration} s dauert; prüfen, ob die Beschriftungen zu ihr gehören</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/utterance.py" />
            <source>{file}, {place}: {fault}, found {raw}; correct the label</source>
            <translation>{file}, {place}: {fault}, gefunden {raw}; Beschriftung korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/phone_sets.py" />
            <source>{file}: a mapping begins with format = {format}, found {document}; if a newer version of the program wrote it, use that</source>
            <translation>{file}: Eine Zuordnung beginnt mit format = {format}, gefunden {document}; stammt sie von einer neueren Programmversion, diese verwenden</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/phone_sets.py" />
            <source>{file}: a mapping is a table [phonemes] with lines like "AA" = "a"; write it like that</source>
            <translation>{file}: Eine Zuordnung ist eine Tabelle [phonemes] mit Zeilen wie "AA" = "a"; so schreiben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/face_csv.py" />
            <source>{file}: a recording of OpenFace has the column {time} and action units such as AU12_r, and this lacks them; record it again with -aus</source>
            <translation>{file}: Eine Aufnahme von OpenFace hat die Spalte {time} und Action Units wie AU12_r, und diese hat sie nicht; mit -aus neu aufnehmen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/audacity.py" />
            <source>{file}: all its labels are points without length; drag each label over its sound and export them again</source>
            <translation>{file}: Alle Beschriftungen sind Punkte ohne Dauer; jede über ihren Laut ziehen und neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/face_csv.py" />
            <source>{file}: all its numbers must be finite, and one is none; record it again</source>
            <translation>{file}: Alle Zahlen müssen endlich sein, und eine ist keine; neu aufnehmen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/table.py" />
            <source>{file}: it cannot be read as CSV ({error}); check the file</source>
            <translation>{file}: Nicht als CSV lesbar ({error}); Datei prüfen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/errors.py" />
            <source>{file}: it is unknown what stands for a phoneme in {self}{more}; map each of these names to a phoneme, in the window or with --map FILE</source>
            <translation>{file}: Unbekannte Namen von Lauten: {self}{more}; jedem Namen ein Phonem zuordnen, im Fenster oder mit --map DATEI</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/table.py" />
            <source>{file}: it lacks the column {missing}; give it the columns {columns}</source>
            <translation>{file}: Die Spalte {missing} fehlt; mit den Spalten {columns} speichern</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/timed_words.py" />
            <source>{file}: it tells {known} speakers apart, {names}; {asked}</source>
            <translation>{file}: Unterscheidet {known} Sprecher, {names}; {asked}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/face_csv.py" />
            <source>{file}: there is no frame with a face in it; record it again</source>
            <translation>{file}: Kein Bild darin zeigt ein Gesicht; neu aufnehmen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/table.py" />
            <source>{file}: there is no row under the header; add one</source>
            <translation>{file}: Keine Zeile unter der Kopfzeile; eine ergänzen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/table.py" />
            <source>{file}: there is no such mouth table; {words}</source>
            <translation>{file}: Diese Mundtabelle fehlt; {words}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/files.py" />
            <source>{file}: there is no tier of intervals named {wanted}, found {names}; choose one</source>
            <translation>{file}: Keine Intervallspur namens {wanted}, gefunden {names}; eine wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/files.py" />
            <source>{file}: there is no tier of intervals with a label, found {names}; label the sounds in one</source>
            <translation>{file}: Keine Intervallspur mit Beschriftungen, gefunden {names}; Laute in einer Spur beschriften</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/lexicon.py" />
            <source>{file}: there is no word in it; write some, or leave the lexicon out</source>
            <translation>{file}: enthält kein Wort; welche eintragen oder das Lexikon weglassen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/textgrid.py" />
            <source>{file}: this is no TextGrid; save it in Praat as a TextGrid, as a text file</source>
            <translation>{file}: kein TextGrid; in Praat als TextGrid-Textdatei speichern</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/phone_sets.py" />
            <source>{file}: this is no TOML file ({error}); correct it</source>
            <translation>{file}: Keine TOML-Datei ({error}); korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/textgrid.py" />
            <source>{file}: this TextGrid is binary; save it in Praat as a text file</source>
            <translation>{file}: Dieses TextGrid ist binär; in Praat als Textdatei speichern</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/utterance_files.py" />
            <source>{file}: this TextGrid is of a sound of {labelled} s, and the sound here lasts {duration} s; check that they belong together, or cut the TextGrid in Praat</source>
            <translation>{file}: Dieses TextGrid gehört zu {labelled} s Audio, die Audiodatei dauert aber {duration} s; prüfen, ob beide zusammengehören, oder das TextGrid in Praat kürzen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/phone_sets.py" />
            <source>{file}: {name} must stand for one of {phonemes_by_label}, found {phoneme}; correct it</source>
            <translation>{file}: {name} muss für eins stehen von {phonemes_by_label}, gefunden {phoneme}; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/lexicon.py" />
            <source>{file}: {word} must be IPA or a list of it, found {ipa}; correct it</source>
            <translation>{file}: {word} muss IPA oder eine Liste davon sein, gefunden {ipa}; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{first} and false silence rises from {old} % to {new} %</source>
            <translation>{first} und falsche Stille steigt von {old} % auf {new} %</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{first} and silence recall falls from {old} % to {new} %</source>
            <translation>{first} und erkannte Stille fällt von {old} % auf {new} %</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/preset_dialogs.py" />
            <source>{first} and {last}</source>
            <translation>{first} und {last}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/feelings.py" />
            <source>{first} and {second} are asked for at one place; keep one, or write [{first_2} 0.5, {second_2} 0.5]</source>
            <translation>{first} und {second} stehen an einer Stelle; eines davon entfernen oder [{first_2} 0.5, {second_2} 0.5] schreiben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_view.py" />
            <source>{first} and {second} recognise different phonemes in {share:.1f} % of the visible frames</source>
            <translation>{first} und {second} erkennen in {share:.1f} % der sichtbaren Frames verschiedene Phoneme</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/encoder/model_folder.py" />
            <source>{folder_variable} is {off}, so files are recognised without Whisper; unset it to use one</source>
            <translation>{folder_variable} ist {off}, daher werden Dateien ohne Whisper erkannt; die Variable löschen, um es zu verwenden</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/batch/record.py" />
            <source>{folder}: cannot be written ({reason}); choose another folder</source>
            <translation>{folder}: Lässt sich nicht schreiben ({reason}); anderen Ordner wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/takes/storage.py" />
            <source>{folder}: this folder cannot be made ({error}); choose another</source>
            <translation>{folder}: Dieser Ordner lässt sich nicht anlegen ({error}); anderen wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/storage/paths.py" />
            <source>{folder}: this folder for recordings cannot be made ({error}); choose another</source>
            <translation>{folder}: Dieser Ordner für Aufnahmen lässt sich nicht anlegen ({error}); anderen wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/takes/storage.py" />
            <source>{folder}: this project cannot be written ({error}); choose another folder</source>
            <translation>{folder}: Dieses Projekt lässt sich nicht schreiben ({error}); anderen Ordner wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/takes/storage.py" />
            <source>{folder}: this project is open in another window or program; close it there first</source>
            <translation>{folder}: Dieses Projekt ist in einem anderen Fenster oder Programm geöffnet; zuerst dort schließen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/utterance_edits.py" />
            <source>{ipa} can't be split at {seconds} s: each part lasts {shortest} ms at least; move the cursor into the phone</source>
            <translation>{ipa} lässt sich bei {seconds} s nicht teilen: Jeder Teil dauert mindestens {shortest} ms; den Cursor in das Phon setzen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/curves_file.py" />
            <source>{key} has {columns} values of {names} and {column} of {name}; export the curves again</source>
            <translation>{key} hat {columns} Werte von {names} und {column} von {name}; Kurven neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/curves_file.py" />
            <source>{key} names {twice} twice; export the curves again</source>
            <translation>{key} nennt {twice} zweimal; Kurven neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/spoken_lanes.py" />
            <source>{kind} [{names}] from {recording}, {start:.2f} to {end:.2f} s.</source>
            <translation>{kind} [{names}] aus {recording}, {start:.2f} bis {end:.2f} s.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/conversion/work.py" />
            <source>{kind} holds no edited keys; leave them out, or choose livelink-csv or gltf</source>
            <translation>{kind} nimmt keine bearbeiteten Keyframes auf; weglassen oder livelink-csv oder gltf wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/variables_panel.py" />
            <source>{kind} over {low:.0f}–{high:.0f} Hz of the {source} spectrum; separation {separation:.0%}</source>
            <translation>{kind} über {low:.0f}–{high:.0f} Hz, Spektrum: {source}; Trennung {separation:.0%}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/tour.py" />
            <source>{k} of {n}</source>
            <translation>{k} von {n}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/scripts.py" />
            <source>{labels}: this file exists beside the audio file and would be overwritten; choose another name for the audio file</source>
            <translation>{labels}: Diese Datei liegt neben der Audiodatei und würde überschrieben; einen anderen Namen für die Audiodatei wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/recognition/templates.py" />
            <source>{label} has no template; leave it out</source>
            <translation>{label} hat keine Vorlage; weglassen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/stream.py" />
            <source>{label} is not there</source>
            <translation>{label} ist nicht vorhanden</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/text_panel.py" />
            <source>{language} (guessed)</source>
            <translation>{language} (vermutet)</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/threedm.py" />
            <source>{left} bytes follow its end; it is damaged, export it again</source>
            <translation>Nach dem Ende folgen noch {left} Byte; beschädigt, neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/adaptation.py" />
            <source>{len} s of {np} phonemes are not enough to adapt to; record {least_seconds} s or more of several phonemes</source>
            <translation>{len} s mit {np} Phonemen reichen nicht zur Anpassung; mindestens {least_seconds} s mit mehreren Phonemen aufnehmen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/fit_panel.py" />
            <source>{letter}: {preset} is in use</source>
            <translation>{letter}: {preset} wird verwendet</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/preset_choice.py" />
            <source>{letter}: {preset}; X uses it</source>
            <translation>{letter}: {preset}; X verwendet es</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/morph_mesh.py" />
            <source>{lost} of the {counts} vertices that move are not in the mesh within {tolerance}: {n_named}{more}; choose the mesh of theirs, or a larger tolerance</source>
            <translation>{lost} von {counts} bewegten Eckpunkten fehlen im Mesh, Toleranz {tolerance}: {n_named}{more}; das zugehörige Mesh oder eine größere Toleranz wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/settings.py" />
            <source>{lower} must not exceed {upper}, got {low} above {high}; lower it</source>
            <translation>{lower} darf nicht über {upper} liegen, gefunden {low} über {high}; senken</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/face_model.py" />
            <source>{mesh}: the mesh has no blend shapes; select its .3dm file together with it</source>
            <translation>{mesh}: Das Mesh hat keine Blendshapes; die zugehörige .3dm-Datei mit auswählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{microphone} was disconnected</source>
            <translation>{microphone} wurde getrennt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/score_strip.py" />
            <source>{minutes:.1f} min labelled</source>
            <translation>{minutes:.1f} min beschriftet</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>{names} and {n} others</source>
            <translation>{names} und {n} weitere</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>{name} (and {n} more)</source>
            <translation>{name} (und {n} weitere)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name} (network)</source>
            <translation>{name} (Netz)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name} (network, synthetic performer)</source>
            <translation>{name} (Netz, künstlicher Darsteller)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/transport/source_bars.py" />
            <source>{name} (not connected)</source>
            <translation>{name} (nicht verbunden)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name} (synthetic performer)</source>
            <translation>{name} (künstlicher Darsteller)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>{name} already exists.</source>
            <translation>{name} ist schon vorhanden.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/inspection/averaged_spectrum.py" />
            <source>{name} and {name_2} have different frequencies; average the sound of one of them again</source>
            <translation>{name} und {name_2} haben verschiedene Frequenzen; eines der beiden neu mitteln</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/inspection/averaged_spectrum.py" />
            <source>{name} and {name_2} went through different filters ({said} against {said_2}); measure them again with the same ones</source>
            <translation>{name} und {name_2} wurden mit verschiedenen Filtern gemessen ({said} gegen {said_2}); bitte mit den gleichen neu messen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/storage/strict_table.py" />
            <source>{name} begins with format = {form}, found {came}; choose another file, or update the program</source>
            <translation>Erwartet wird {name}, beginnend mit format = {form}, gefunden {came}; andere Datei wählen oder das Programm aktualisieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/tiers.py" />
            <source>{name} can't be split at {seconds} s: each part lasts {shortest} ms at least; move the cursor into the label</source>
            <translation>{name} lässt sich bei {seconds} s nicht teilen: Jeder Teil dauert mindestens {shortest} ms; den Cursor in die Beschriftung setzen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/inspection/speaker_spectra.py" />
            <source>{name} cannot be measured again, since it does not say of which sound file it is; average the sound anew</source>
            <translation>{name} kann nicht neu gemessen werden, da die Audiodatei nicht angegeben ist; die Audiodatei neu mitteln</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/inspection/speaker_spectra.py" />
            <source>{name} cannot be measured again, since {name_2} is not there any more; put it back, or average another sound</source>
            <translation>{name} kann nicht neu gemessen werden, da {name_2} nicht mehr vorhanden ist; die Datei zurücklegen oder eine andere mitteln</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/storage/strict_table.py" />
            <source>{name} cannot have an entry {key}; {words}</source>
            <translation>{name} kann keinen Eintrag {key} haben; {words}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/headers.py" />
            <source>{name} claims {size} bytes</source>
            <translation>{name} gibt {size} Byte an</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/exports/exporter.py" />
            <source>{name} counts no frames, so it has no frame rate; leave it out</source>
            <translation>{name} zählt keine Bilder und hat daher keine Bildrate; weglassen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/table.py" />
            <source>{name} gives {given} alone; give attack and release, or none of them</source>
            <translation>{name} gibt nur {given} an; attack und release angeben oder keins</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/movestate.py" />
            <source>{name} goes from {most_percent} to {most_percent_2} %, got {percent}; choose less</source>
            <translation>{name} geht von {most_percent} bis {most_percent_2} %, gefunden {percent}; weniger wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/exports/exporter.py" />
            <source>{name} has curves and no cues, so there is no shortest cue; leave it out</source>
            <translation>{name} hat Kurven und keine Mundform-Einträge, also auch keine kürzeste Dauer; weglassen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/tiers.py" />
            <source>{name} has no label there to merge with; choose one that has a neighbour</source>
            <translation>{name} hat dort keine Beschriftung, mit der sie sich verbinden lässt; eine mit Nachbarn wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/key_layer.py" />
            <source>{name} has two curves; join them</source>
            <translation>{name} hat zwei Kurven; zusammenfassen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/speech/pinyin/table.py" />
            <source>{name} has {letter}, which is no letter; give it a single character</source>
            <translation>{name} enthält {letter}, keinen Buchstaben; ein einzelnes Zeichen angeben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/input.py" />
            <source>{name} has {n_inputs} channels and so no channel {channel}; choose another</source>
            <translation>{name} hat {n_inputs} Kanäle und daher keinen Kanal {channel}; anderen wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/exports/exporter.py" />
            <source>{name} has {rate} frames per second, the movement {rate_2}; make it with these</source>
            <translation>{name} hat {rate} Bilder je Sekunde, die Bewegung {rate_2}; mit dieser Rate erstellen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/key_layer.py" />
            <source>{name} has {times} times and {offsets} offsets; give as many of each</source>
            <translation>{name} hat {times} Zeiten und {offsets} Versätze; gleich viele angeben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/exports/exporter.py" />
            <source>{name} holds no expressions; leave them out, or choose livelink-csv or gltf</source>
            <translation>{name} nimmt keine Ausdrücke auf; weglassen oder livelink-csv oder gltf wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/exports/exporter.py" />
            <source>{name} holds the {known} movestates {movestates} ... {movestates_2}, which are not those of the table {name_2}; choose another table</source>
            <translation>{name} enthält die {known} Blendshapes {movestates} ... {movestates_2}, die Tabelle {name_2} hat andere; andere Tabelle wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_tree.py" />
            <source>{name} is a number, such as 0.25; found {text}</source>
            <translation>{name} ist eine Zahl, etwa 0.25; gefunden: {text}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/features/variables.py" />
            <source>{name} is divided by {per}, which is not measured or is divided itself; name a variable that stands by itself</source>
            <translation>{name} wird durch {per} geteilt, das nicht gemessen oder selbst geteilt wird; eine eigenständige Variable angeben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/tiers.py" />
            <source>{name} is labelled from {start} to {end} s; delete it first, or select a segment beside it</source>
            <translation>{name} ist von {start} bis {end} s beschriftet; zuerst löschen oder daneben auswählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/exports/exporter.py" />
            <source>{name} is made of cues, or of movestates other than {movestates} ... {movestates_2}; leave the movement out</source>
            <translation>{name} besteht aus Mundform-Einträgen oder anderen Blendshapes als {movestates} ... {movestates_2}; Bewegung weglassen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/visemes.py" />
            <source>{name} is no viseme of the phoneme {label}; correct the viseme set</source>
            <translation>{name} ist kein Visem des Phonems {label}; Visemsatz korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/exports/exporter.py" />
            <source>{name} knows the shapes {known}, but the table {name_2} has {shape}; choose another table</source>
            <translation>{name} kennt die Mundformen {known}, die Tabelle {name_2} hat aber {shape}; andere Tabelle wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/storage/strict_table.py" />
            <source>{name} lacks {key}; add it</source>
            <translation>{key} fehlt ({name}); hinzufügen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/speech/pinyin/table.py" />
            <source>{name} lacks {part}; add it to the list of one of its letters</source>
            <translation>In {name} fehlt {part}; in die Liste eines ihrer Buchstaben aufnehmen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/exports/exporter.py" />
            <source>{name} moves no mesh; leave {name_2} out, or choose gltf</source>
            <translation>{name} bewegt kein Mesh; {name_2} weglassen oder gltf wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/table.py" />
            <source>{name} moves {name_2}, which is no movestate; use one of movestates, or add it</source>
            <translation>{name} bewegt {name_2}, das kein Blendshape ist; einen aus movestates verwenden oder dort hinzufügen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/exports/exporter.py" />
            <source>{name} must be a factor in {limits}, got {factor}; choose another</source>
            <translation>{name} muss ein Faktor in {limits} sein, gefunden {factor}; anderen wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/recognition/rules.py" />
            <source>{name} must be a finite number within ±3.4e38, got {value}; correct it</source>
            <translation>{name} muss eine endliche Zahl in ±3.4e38 sein, gefunden {value}; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/recognition/templates.py" />
            <source>{name} must have {n_cepstra} numbers in templates, got {row}; correct it</source>
            <translation>{name} muss in templates {n_cepstra} Zahlen haben, gefunden {row}; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/recognition/templates.py" />
            <source>{name} must hold finite numbers within ±3.4e38 in templates, got {value}; correct it</source>
            <translation>{name} muss in templates endliche Zahlen in ±3.4e38 enthalten, gefunden {value}; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/features/variables.py" />
            <source>{name} must range within 0..{sample_rate} Hz and upwards, got {low}..{high} Hz; correct it</source>
            <translation>{name} muss aufsteigend in 0..{sample_rate} Hz liegen, gefunden {low}..{high} Hz; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/style.py" />
            <source>{name} names {name_2}, which is no movestate; {movestates}</source>
            <translation>{name} nennt {name_2}, das kein Movestate ist; {movestates}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/speech/pinyin/table.py" />
            <source>{name} names {part} twice; remove one</source>
            <translation>{name} nennt {part} zweimal; eins entfernen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/speech/pinyin/table.py" />
            <source>{name} names {syllable}, which is no syllable without tone; correct it</source>
            <translation>{name} nennt {syllable}, das keine Silbe ohne Ton ist; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/live/loopback.py" />
            <source>{name} opens, but does nothing within {stalled} s; check it, or choose another</source>
            <translation>{name} lässt sich öffnen, tut aber {stalled} s lang nichts; prüfen oder anderes Gerät wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name} reads 0, since it begins at {low} Hz and the low-pass ends at {end} Hz; raise the low-pass.</source>
            <translation>{name} ist 0, weil es bei {low} Hz beginnt und der Tiefpass bei {end} Hz endet; den Tiefpass anheben.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name} reads 0, since it begins at {low} Hz and the spectrum ends at {end} Hz; quantise less.</source>
            <translation>{name} ist 0, weil es bei {low} Hz beginnt und das Spektrum bei {end} Hz endet; weniger quantisieren.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name} reads 0, since no band lies within {low} to {high} Hz; widen its range.</source>
            <translation>{name} ist 0, weil zwischen {low} und {high} Hz kein Band liegt; Bereich erweitern.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name} reads 0, since the mel filter bank is off; switch Mel on.</source>
            <translation>{name} ist 0, weil die Mel-Filterbank aus ist; Mel einschalten.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/table.py" />
            <source>{name} says twice what {side} does; remove one</source>
            <translation>{name} bestimmt {side} zweimal; eins entfernen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/exports/exporter.py" />
            <source>{name} separates names by spaces, so {shape} of the table {name_2} cannot be one; rename it there</source>
            <translation>{name} trennt Namen durch Leerzeichen, daher geht {shape} der Tabelle {name_2} nicht; dort umbenennen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/speech/pinyin/table.py" />
            <source>{name} {shape} names {part}, which does not exist; {words}</source>
            <translation>{name} {shape} nennt {part}, das es nicht gibt; {words}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/script.py" />
            <source>{name}, line {odd}: a table has the name of a sound, a tab and its words; add the tab</source>
            <translation>{name}, Zeile {odd}: Eine Tabelle enthält Name der Audiodatei, Tabulator und Text; Tabulator einfügen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>{name}, {rate:g} syllables/s</source>
            <translation>{name}, {rate:g} Silben/s</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/score_strip.py" />
            <source>{name}, {start:.1f}–{end:.1f} s</source>
            <translation>{name}, {start:.1f}–{end:.1f} s</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_model.py" />
            <source>{name}: a file of this name is there, or can't be; choose another name.</source>
            <translation>{name}: Eine Datei dieses Namens gibt es schon, oder es kann sie nicht geben; einen anderen Namen wählen.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/recognition/model.py" />
            <source>{name}: a model is smaller than 8 MB, this has {st_size} MB; choose another</source>
            <translation>{name}: Ein Modell ist kleiner als 8 MB, dieses hat {st_size} MB; anderes wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/conversion/driving.py" />
            <source>{name}: a network moves a face by a sound, and this has none; have a voice say it, or choose another --text-driver</source>
            <translation>{name}: Ein Netz bewegt ein Gesicht nach dem Ton, und hier gibt es keinen; von einer Stimme sprechen lassen oder ein anderes --text-driver wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/takes/take.py" />
            <source>{name}: a newer version of the program wrote this project (version {version} of its list, known is {version_2}); open it with that</source>
            <translation>{name}: Dieses Projekt stammt von einer neueren Programmversion (Version {version} der Liste, bekannt ist {version_2}); mit dieser öffnen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/encoder/live.py" />
            <source>{name}: a real-time model has at most 12 MB, this has {size}; use 8 bits</source>
            <translation>{name}: Ein Echtzeitmodell hat höchstens 12 MB, dieses {size}; 8 Bit verwenden</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/recording.py" />
            <source>{name}: a recording is a .wav or a .flac file; let its name end like that</source>
            <translation>{name}: Eine Aufnahme ist eine .wav- oder .flac-Datei; den Namen so enden lassen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/batch/record.py" />
            <source>{name}: another batch (process {pid} on {host}) writes into this folder; wait until it has ended, or choose another folder</source>
            <translation>{name}: Ein anderer Stapel (Prozess {pid} auf {host}) schreibt in diesen Ordner; dessen Ende abwarten oder anderen Ordner wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/io.py" />
            <source>{name}: FBX cannot be read; open it in Blender, and export it as glTF (.glb) with shape keys</source>
            <translation>{name}: FBX ist nicht lesbar; in Blender öffnen und als glTF (.glb) mit Shape Keys exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/recording.py" />
            <source>{name}: FLAC takes {low}..{high} Hz and at most {most} channels, got {rate} Hz and {n_channels}; record to a .wav file</source>
            <translation>{name}: FLAC erlaubt {low}..{high} Hz und höchstens {most} Kanäle, gefunden {rate} Hz und {n_channels}; als .wav aufnehmen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/files.py" />
            <source>{name}: it can only be read from its beginning; {advice} as WAV</source>
            <translation>{name}: Lässt sich nur vom Anfang an lesen; {advice}, als WAV</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/recording.py" />
            <source>{name}: it cannot be made in {folder} ({error}); choose another folder or name</source>
            <translation>{name}: Lässt sich in {folder} nicht anlegen ({error}); anderen Ordner oder Namen wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/table_file.py" />
            <source>{name}: it cannot be read ({error}); choose another file</source>
            <translation>{name}: Nicht lesbar ({error}); andere Datei wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/speech/program.py" />
            <source>{name}: it failed with exit code {returncode} ({said}); try it by itself</source>
            <translation>{name}: Mit Exitcode {returncode} gescheitert ({said}); für sich ausprobieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/speech/program.py" />
            <source>{name}: it has not spoken within {timeout} s; try it by itself</source>
            <translation>{name}: Hat in {timeout} s nicht gesprochen; für sich ausprobieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/conversion/spoken_texts.py" />
            <source>{name}: it has the keys of one sound, and there are {sounds}; use --keys auto</source>
            <translation>{name}: Enthält die Keyframes einer Audiodatei, es sind {sounds}; --keys auto verwenden</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/files.py" />
            <source>{name}: it has {has} and so no channel {number}; choose {choice}</source>
            <translation>{name}: Hat {has} und daher keinen Kanal {number}; {choice} wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/io.py" />
            <source>{name}: it has {target} vertices, and the base has {base}; export both alike</source>
            <translation>{name}: Es hat {target} Vertices, die Form in Ruhe hat {base}; beide gleich exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/script.py" />
            <source>{name}: it holds the words of one sound, and there are {sounds}; write a table with the name of a sound, a tab and its words in each line</source>
            <translation>{name}: Enthält den Text nur einer Audiodatei, es sind aber {sounds}; eine Tabelle schreiben, je Zeile Name der Audiodatei, Tabulator und Text</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/files.py" />
            <source>{name}: it is cut off after {block} of the {duration} s that its header announces; copy or export it again</source>
            <translation>{name}: Nach {block} der in den Kopfdaten angegebenen {duration} s abgeschnitten; neu kopieren oder exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/files.py" />
            <source>{name}: it is damaged after {self}; copy or export it again</source>
            <translation>{name}: Nach {self} beschädigt; neu kopieren oder exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/speech/program.py" />
            <source>{name}: it wrote no sound file; put {output} where its name belongs in the command</source>
            <translation>{name}: Keine Audiodatei geschrieben; im Befehl {output} an die Stelle ihres Namens setzen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/io.py" />
            <source>{name}: its ending must be one of {kinds}; choose another file</source>
            <translation>{name}: Die Endung muss eine sein von {kinds}; andere Datei wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/face_learning.py" />
            <source>{name}: its face has no blend shapes of a mouth; record ARKit's</source>
            <translation>{name}: Das Gesicht hat keine Blendshapes eines Mundes; die von ARKit aufnehmen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/files.py" />
            <source>{name}: its header does not say how long the sound is; {advice}</source>
            <translation>{name}: Die Kopfdaten nennen keine Dauer; {advice}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/files.py" />
            <source>{name}: its sample rate of {rate} Hz is too {fault}; it must lie in {lowest_rate}..{highest_rate} Hz, so export it again at {sample_rate} Hz</source>
            <translation>{name}: Die Abtastrate von {rate} Hz ist zu {fault}; erlaubt sind {lowest_rate}..{highest_rate} Hz, daher mit {sample_rate} Hz neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/files.py" />
            <source>{name}: labels are read from .TextGrid, .txt (Audacity) and .csv files; choose one of them</source>
            <translation>{name}: Beschriftungen werden aus .TextGrid-, .txt- (Audacity) und .csv-Dateien gelesen; eine davon wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/tiers.py" />
            <source>{name}: labels are written to .TextGrid, .txt and .csv files; choose such a name</source>
            <translation>{name}: Beschriftungen werden als .TextGrid, .txt oder .csv gespeichert; einen solchen Namen wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/driver.py" />
            <source>{name}: no channel of this table is a blend shape of a mouth as ARKit names them, such as jawOpen; build it of recordings that have them</source>
            <translation>{name}: Kein Kanal dieser Tabelle ist ein Mund-Blendshape mit ARKit-Namen wie jawOpen; Tabelle aus Aufnahmen mit solchen Kanälen erstellen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/inspection/speaker_spectra.py" />
            <source>{name}: no frame of it was found; choose a longer segment or more recordings</source>
            <translation>{name}: kein Frame gefunden; einen längeren Abschnitt oder mehr Aufnahmen wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/io.py" />
            <source>{name}: no vertex moves, it is the base's shape; leave it out, or export it again</source>
            <translation>{name}: Kein Vertex bewegt sich, es ist die Form in Ruhe; weglassen oder neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/inspection/speaker_spectra.py" />
            <source>{name}: nothing in its labels is one of the phonemes; choose others</source>
            <translation>{name}: in den Beschriftungen kommt keines der Phoneme vor; andere wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/tiers.py" />
            <source>{name}: only a TextGrid holds {tiers} tiers; save the labels as .TextGrid</source>
            <translation>{name}: Nur ein TextGrid fasst {tiers} Spuren; Beschriftungen als .TextGrid speichern</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/takes/take.py" />
            <source>{name}: pauses must follow one another in the sound, got {pauses}; correct them</source>
            <translation>{name}: Pausen müssen in der Aufnahme aufeinander folgen, gefunden {pauses}; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/files.py" />
            <source>{name}: samples must be finite numbers, found NaN or infinity at {when}; repair it in an audio editor and export it again</source>
            <translation>{name}: NaN oder unendlicher Abtastwert bei {when}; in einem Audio-Editor reparieren und neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/face_model.py" />
            <source>{name}: the face has none of the blend shapes of this table; choose one of these tables: {names}.</source>
            <translation>{name}: Das Gesicht hat keine Blendshapes dieser Tabelle; eine dieser Tabellen wählen: {names}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/face_model.py" />
            <source>{name}: the face has none of the blend shapes of this table; write a mouth table for the face and load it.</source>
            <translation>{name}: Das Gesicht hat keine Blendshapes dieser Tabelle; eine Mundtabelle für das Gesicht schreiben und laden.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/files.py" />
            <source>{name}: the file is empty (0 bytes); copy or record it again</source>
            <translation>{name}: Die Datei ist leer (0 Bytes); noch einmal kopieren oder aufnehmen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name}: the file is truncated after the audio, which is complete</source>
            <translation>{name}: Datei hinter dem Ton abgeschnitten; der Ton ist vollständig</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name}: the file is truncated; its header announces {announced} s, but it contains {there} s</source>
            <translation>{name}: Datei abgeschnitten; der Header kündigt {announced} s an, enthalten sind {there} s</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/encoder/head.py" />
            <source>{name}: the head of the encoder cannot be read ({error}); put it beside its preset</source>
            <translation>{name}: Der Kopf des Encoders ist nicht lesbar ({error}); neben sein Preset legen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/encoder/head.py" />
            <source>{name}: the head of the encoder is damaged; get it anew</source>
            <translation>{name}: Der Kopf des Encoders ist beschädigt; neu beschaffen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name}: the header gives no duration; the file contains {there} s</source>
            <translation>{name}: Der Header nennt keine Dauer; enthalten sind {there} s</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/recognition/model.py" />
            <source>{name}: the model cannot be read ({error}); put it beside its preset</source>
            <translation>{name}: Das Modell ist nicht lesbar ({error}); neben sein Preset legen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/recognition/model.py" />
            <source>{name}: the model's file is damaged; get it anew, or train it again</source>
            <translation>{name}: Die Modelldatei ist beschädigt; neu beschaffen oder neu trainieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/recording.py" />
            <source>{name}: the name of a phone is one word, found {bad}; correct it</source>
            <translation>{name}: Der Name eines Lauts ist ein Wort, gefunden {bad}; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name}: the preset was calibrated with another real-time model; calibrate it again</source>
            <translation>{name}: Das Preset wurde mit einem anderen Echtzeitmodell kalibriert; neu kalibrieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/batch/runner.py" />
            <source>{name}: the process that worked on it died, twice; try it alone, or leave it out</source>
            <translation>{name}: Der Prozess für diese Datei ist zweimal abgestürzt; einzeln versuchen oder weglassen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/morph_mesh.py" />
            <source>{name}: the program's own head cannot be read; install the program again</source>
            <translation>{name}: Der eingebaute Kopf ist nicht lesbar; Programm neu installieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/recording.py" />
            <source>{name}: the recordings of a table must have the same channels and rate as {name_2} ({first} at {rate} frames a second), found {self} at {rate_2}; export it again, or leave it out</source>
            <translation>{name}: Die Aufnahmen einer Tabelle müssen dieselben Kanäle und dieselbe Rate haben wie {name_2} ({first} bei {rate} Bildern je Sekunde), gefunden {self} bei {rate_2}; neu exportieren oder weglassen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/headers.py" />
            <source>{name}: the sizes in its header do not match the file ({lie}), so {advice}</source>
            <translation>{name}: Die Größen in den Kopfdaten passen nicht zur Datei ({lie}), daher {advice}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/own_sound.py" />
            <source>{name}: the sound of the recording {recording} is not in the folder {self} beside the table; put it there, or use a voice</source>
            <translation>{name}: der Ton der Aufnahme {recording} liegt nicht im Ordner {self} neben der Tabelle; ihn dort ablegen oder eine Stimme benutzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name}: the speech encoder needs onnxruntime, which is not installed; install phonemeanalyser[encoder]</source>
            <translation>{name}: Für den Sprach-Encoder fehlt onnxruntime; phonemeanalyser[encoder] installieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/recording.py" />
            <source>{name}: the weights of a recording may have {largest_weights} MB, these have {nbytes} MB; cut it into sentences</source>
            <translation>{name}: Die Gewichte einer Aufnahme dürfen {largest_weights} MB belegen, diese {nbytes} MB; in Sätze schneiden</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/timed_words.py" />
            <source>{name}: the word {text} begins at {start} s, but the sound lasts {duration} s; check whether the words belong to this sound</source>
            <translation>{name}: Das Wort {text} beginnt bei {start} s, die Audiodatei dauert aber {duration} s; prüfen, ob die Wörter zu ihr gehören</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/files.py" />
            <source>{name}: there are no samples in it; record or export it again</source>
            <translation>{name}: Es sind keine Abtastwerte darin; noch einmal aufnehmen oder exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/recording.py" />
            <source>{name}: there is a file of that name, which a recording does not overwrite; choose another name</source>
            <translation>{name}: Eine Datei dieses Namens gibt es schon, eine Aufnahme überschreibt sie nicht; einen anderen Namen wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/keywords.py" />
            <source>{name}: there is no channel {name_2}; {words}</source>
            <translation>{name}: Es gibt keinen Kanal {name_2}; {words}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/recording.py" />
            <source>{name}: there is no folder {folder}; make it or choose another</source>
            <translation>{name}: Den Ordner {folder} gibt es nicht; anlegen oder einen anderen wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/files.py" />
            <source>{name}: there is no label in it; label the sounds and save it again</source>
            <translation>{name}: enthält keine Beschriftung; Laute beschriften und neu speichern</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/storage/strict_table.py" />
            <source>{name}: there is no phoneme {key}; {words}</source>
            <translation>{name}: Es gibt kein Phonem {key}; {words}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/table_file.py" />
            <source>{name}: there is no recording {name_2} in this table; they are called as their files are, such as {some}</source>
            <translation>{name}: Keine Aufnahme {name_2} in dieser Tabelle; die Namen sind die der Dateien, etwa {some}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/conversion/spoken_texts.py" />
            <source>{name}: there is no sound file in this folder; name another</source>
            <translation>{name}: Keine Audiodatei in diesem Ordner; anderen angeben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/conversion/driving.py" />
            <source>{name}: there is no syllable of pinyin in what is said; choose another driver</source>
            <translation>{name}: Keine Pinyin-Silbe im Gesprochenen; andere Steuerung wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/script.py" />
            <source>{name}: there is no text in it for {sounds}; a line holds the name of a sound, a tab and its words</source>
            <translation>{name}: Kein Text für {sounds} enthalten; je Zeile Name der Audiodatei, Tabulator und Text schreiben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/utterance_files.py" />
            <source>{name}: there is no tier named {phones} with a label, or {syllables} of pinyin; add one in Praat, or align it by its words</source>
            <translation>{name}: Keine Spur namens {phones} mit Beschriftungen und keine Spur {syllables} mit Pinyin gefunden; in Praat anlegen oder an den Wörtern ausrichten</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/script.py" />
            <source>{name}: there is no word in it; write what is said</source>
            <translation>{name}: enthält kein Wort; aufschreiben, was gesagt wird</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/timed_words.py" />
            <source>{name}: there is no word with a time in it; it must be a TextGrid with a tier named words, or JSON of Whisper, WhisperX, ElevenLabs or Azure that was made with times of words</source>
            <translation>{name}: Kein Wort mit Zeitangabe gefunden; nötig ist ein TextGrid mit einer Spur namens words oder JSON von Whisper, WhisperX, ElevenLabs oder Azure mit Wortzeiten</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/takes/take.py" />
            <source>{name}: this folder is a corpus that was not made of takes; choose an empty folder for it</source>
            <translation>{name}: Dieser Ordner ist ein Korpus, der nicht aus Takes besteht; leeren Ordner wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/libsndfile.py" />
            <source>{name}: this is a device, not an audio file; choose a file</source>
            <translation>{name}: Das ist ein Gerät, keine Audiodatei; eine Datei wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/recording.py" />
            <source>{name}: this is a folder; choose a name for a new file</source>
            <translation>{name}: Dies ist ein Ordner; einen Namen für eine neue Datei wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/io.py" />
            <source>{name}: this is a mesh without morph targets; use 'movestates export'</source>
            <translation>{name}: Dies ist ein Mesh ohne Morph-Targets; 'movestates export' verwenden</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/exports/gltf.py" />
            <source>{name}: this is no face that can be moved; name a .glb, .vrm or .gltf (glTF 2.0), .obj or .x</source>
            <translation>{name}: Kein Gesicht, das sich bewegen lässt; .glb, .vrm oder .gltf (glTF 2.0), .obj oder .x angeben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/timed_words.py" />
            <source>{name}: this is no JSON ({error}); export the words again</source>
            <translation>{name}: Kein JSON ({error}); Wörter neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/table_file.py" />
            <source>{name}: this is no table of performances, or a damaged one ({reason}); build it anew with `phonemeanalyser performance build`</source>
            <translation>{name}: Keine Tabelle von Gesichtsaufnahmen oder beschädigt ({reason}); mit `phonemeanalyser performance build` neu erstellen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name}: this is not a real-time model, or it is damaged; download it again</source>
            <translation>{name}: kein Echtzeitmodell oder beschädigt; neu herunterladen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name}: this is not an audio file that can be read; choose a WAV, AIFF, FLAC, OGG, MP3 or M4A file</source>
            <translation>{name}: keine lesbare Audiodatei; WAV, AIFF, FLAC, OGG, MP3 oder M4A wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/files.py" />
            <source>{name}: this is not an audio file that can be read{reason}; choose a WAV, AIFF, FLAC, OGG, MP3 or M4A file</source>
            <translation>{name}: Keine lesbare Audiodatei{reason}; eine WAV-, AIFF-, FLAC-, OGG-, MP3- oder M4A-Datei wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/recording.py" />
            <source>{name}: this machine's libsndfile cannot write FLAC; record to a .wav file</source>
            <translation>{name}: Die libsndfile dieses Computers kann kein FLAC schreiben; als .wav aufnehmen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/speech/program.py" />
            <source>{name}: this program cannot be started ({error}); check the command</source>
            <translation>{name}: Dieses Programm lässt sich nicht starten ({error}); Befehl prüfen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/recording.py" />
            <source>{name}: this sound cannot be written as FLAC ({error}); record it again</source>
            <translation>{name}: Diese Aufnahme lässt sich nicht als FLAC schreiben ({error}); neu aufnehmen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/live/recorder.py" />
            <source>{name}: this table cannot be written ({strerror}); record without the phonemes beside it</source>
            <translation>{name}: Diese Tabelle lässt sich nicht schreiben ({strerror}); ohne Phonemtabelle aufnehmen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/choice.py" />
            <source>{name}: this table of performances is damaged (a unit is not in its recording); build it anew with `phonemeanalyser performance build`</source>
            <translation>{name}: Diese Tabelle von Gesichtsaufnahmen ist beschädigt (eine Einheit fehlt in ihrer Aufnahme); mit `phonemeanalyser performance build` neu erstellen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/takes/storage.py" />
            <source>{name}: this take is not in the project any more; open the project again</source>
            <translation>{name}: Dieser Take ist nicht mehr im Projekt; das Projekt neu öffnen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/takes/take.py" />
            <source>{name}: what counts of a take must lie in its {duration} s, got {start}..{end} s; choose a segment of the sound</source>
            <translation>{name}: Der verwendete Bereich eines Takes muss in seinen {duration} s liegen, gefunden {start}..{end} s; anderes Segment wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/io.py" />
            <source>{name}: would be larger than {largest} MB; leave out some movestates</source>
            <translation>{name}: Würde größer als {largest} MB; einige Blendshapes weglassen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/recording.py" />
            <source>{name}: writing to {folder} is not permitted; change its permissions or choose another folder</source>
            <translation>{name}: Schreiben in {folder} ist nicht erlaubt; Rechte ändern oder einen anderen Ordner wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_layout.py" />
            <source>{name}: {certainty}. It isn't compared with the recognised phoneme, and is never an error.</source>
            <translation>{name}: {certainty}. Wird nicht mit dem erkannten Phonem verglichen und gilt nie als Fehler.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/files.py" />
            <source>{name}: {error}</source>
            <translation>{name}: {error}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/inspection/averaged_spectrum.py" />
            <source>{name}: {error}; choose a file saved by Save Curve</source>
            <translation>{name}: {error}; eine mit „Kurve speichern“ erzeugte Datei wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/exports/gltf.py" />
            <source>{name}: {fault}; save the face as one GLB file with everything in it</source>
            <translation>{name}: {fault}; das Gesicht als eine GLB-Datei mit allem darin speichern</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/conversion/spoken_texts.py" />
            <source>{name}: {lasts}; cut it into shorter ones</source>
            <translation>{name}: {lasts}; in kürzere Stücke schneiden</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/conversion/driving.py" />
            <source>{name}: {needs_words}, which are unknown; give the text with --text, or the text or labels with --script</source>
            <translation>{name}: {needs_words}, die unbekannt sind; den Text oder Text beziehungsweise Beschriftungen je Datei angeben (--text, --script)</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/storage/files.py" />
            <source>{name}: {what} has at most {largest} MB, this has {tenths} MB; choose another</source>
            <translation>{name}: Zu groß ({what}): höchstens {largest} MB, diese Datei hat {tenths} MB; andere wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/recording.py" />
            <source>{name}: {what}, so nothing can be recorded; {advice}</source>
            <translation>{name}: {what}, daher lässt sich nichts aufnehmen; {advice}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/recording.py" />
            <source>{name}: {what}, so the sound is not kept; {advice}</source>
            <translation>{name}: {what}, daher bleibt die Aufnahme nicht erhalten; {advice}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{name}; its channels cancel each other out when mixed, so choose one of them</source>
            <translation>{name}; Kanäle löschen sich beim Mischen aus, einen davon wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/driver_model.py" />
            <source>{network}: {note}.</source>
            <translation>{network}: {note}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>{n} audio files were skipped. The first one: {refusal}</source>
            <translation>{n} Audiodateien wurden übersprungen. Die erste: {refusal}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>{n} channels</source>
            <translation>{n} Kanäle</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_dialogs.py" />
            <source>{n} curves of {seconds:.1f} s of sound</source>
            <translation>{n} Kurven aus {seconds:.1f} s Ton</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/curves.py" />
            <source>{n} curves saved in {target}</source>
            <translation>{n} Kurven gespeichert in {target}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_model.py" />
            <source>{n} deleted takes removed from the disk.</source>
            <translation>{n} gelöschte Takes vom Datenträger entfernt.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/export_dialog.py" />
            <source>{n} files already exist, such as {name}.</source>
            <translation>{n} Dateien sind schon vorhanden, zum Beispiel {name}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/preset_dialogs.py" />
            <source>{n} files written to {folder}. README.md describes the next steps.</source>
            <translation>{n} Dateien in {folder} geschrieben. README.md beschreibt die nächsten Schritte.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>{n} frames not drawn</source>
            <translation>{n} Frames nicht gezeichnet</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/averaged_view.py" />
            <source>{n} frames since {event}; {front_end}</source>
            <translation>{n} Frames seit {event}; {front_end}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>{n} from 1 speaker</source>
            <translation>{n}, 1 Sprecher</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>{n} from {speakers} speakers</source>
            <translation>{n}, {speakers} Sprecher</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_painter.py" />
            <source>{n} further variables of these rules</source>
            <translation>{n} weitere Variablen dieser Regeln</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/keys/key_panel.py" />
            <source>{n} key</source>
            <translation>{n} Keyframe</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/keys/key_panel.py" />
            <source>{n} keys</source>
            <translation>{n} Keyframes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_model.py" />
            <source>{n} label files for {program} written to {folder}.</source>
            <translation>{n} Beschriftungsdateien für {program} in {folder} geschrieben.</translation>
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
            <location filename="../../../engine/phonemeengine/mouth/files/threedm.py" />
            <source>{n} lines of a vertex number and a vector must follow line {begin}; correct it</source>
            <translation>Auf Zeile {begin} müssen {n} Zeilen mit Eckpunktnummer und Vektor folgen; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/time_line.py" />
            <source>{n} more</source>
            <translation>{n} weitere</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/workbench_view.py" />
            <source>{n} of 10 phonemes</source>
            <translation>{n} von 10 Phonemen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/head/mapping_dialog.py" />
            <source>{n} of {all} blend shapes are mapped.</source>
            <translation>{n} von {all} Blendshapes sind zugeordnet.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/comparison.py" />
            <source>{n} place</source>
            <translation>{n} Stelle</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/comparison.py" />
            <source>{n} places</source>
            <translation>{n} Stellen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>{n} points</source>
            <translation>{n} Punkte</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/time_line.py" />
            <source>{n} poor match</source>
            <translation>{n} passt schlecht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/time_line.py" />
            <source>{n} poor matches</source>
            <translation>{n} passen schlecht</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/score_strip.py" />
            <source>{n} recordings</source>
            <translation>{n} Aufnahmen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/rule_editor.py" />
            <source>{n} rules need attention (⚠).</source>
            <translation>{n} Regeln prüfen (⚠).</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>{n} s</source>
            <translation>{n} s</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{n} segments of {sound}</source>
            <translation>{n} Abschnitte von {sound}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_model.py" />
            <source>{n} single sounds</source>
            <translation>{n} einzelne Laute</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{n} sounds</source>
            <translation>{n} Audiodateien</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/time_line.py" />
            <source>{n} word</source>
            <translation>{n} Wort</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/time_line.py" />
            <source>{n} words</source>
            <translation>{n} Wörter</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/curves.py" />
            <source>{one} and {other}: {decibels:.1f} dB, up to {highest:.0f} Hz</source>
            <translation>{one} und {other}: {decibels:.1f} dB, bis {highest:.0f} Hz</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/curves.py" />
            <source>{one} and {other}: {decibels:.1f} dB, up to {highest:.0f} Hz, both measured again with the current filters</source>
            <translation>{one} und {other}: {decibels:.1f} dB, bis {highest:.0f} Hz, beide mit den aktuellen Filtern neu gemessen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>{output} stands for the WAV file to write, {text} for the text; without {text}, the program reads the text from standard input. If it writes a TextGrid beside the WAV file, its times are used.</source>
            <translation>{output} steht für die zu schreibende WAV-Datei, {text} für den Text; ohne {text} liest das Programm den Text von der Standardeingabe. Schreibt es ein TextGrid neben die WAV-Datei, gelten dessen Zeiten.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/app.py" />
            <source>{out}: the picture could not be written; choose another location with -o</source>
            <translation>{out}: Das Bild konnte nicht geschrieben werden; mit -o einen anderen Ort wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/encoder/model_folder.py" />
            <source>{own}: what was fetched is no Whisper model; try again, or name a folder</source>
            <translation>{own}: Was geladen wurde, ist kein Whisper-Modell; erneut versuchen oder einen Ordner angeben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/encoder/whisper.py" />
            <source>{parent}: the Whisper model cannot be opened ({reason}); get it anew, or choose another folder</source>
            <translation>{parent}: Das Whisper-Modell lässt sich nicht öffnen ({reason}); neu laden oder anderen Ordner wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/encoder/whisper.py" />
            <source>{parent}: there is no Whisper model, {name} is missing; choose its folder, or fetch it</source>
            <translation>{parent}: Kein Whisper-Modell, {name} fehlt; den richtigen Ordner wählen oder das Modell laden</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/shipping/targets.py" />
            <source>{path}: another file is there, or it was changed; choose another folder, or have it replaced (--overwrite)</source>
            <translation>{path}: Dort liegt eine andere oder geänderte Datei; anderen Ordner wählen oder ersetzen lassen (--overwrite)</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/shipping/targets.py" />
            <source>{path}: cannot be read ({error}); choose another folder</source>
            <translation>{path}: Nicht lesbar ({error}); anderen Ordner wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/plot.py" />
            <source>{path}: cannot be written ({fault}); choose another folder</source>
            <translation>{path}: kann nicht geschrieben werden ({fault}); einen anderen Ordner wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/scripts.py" />
            <source>{path}: cannot be written ({reason_of}); choose another folder</source>
            <translation>{path}: Die Datei kann nicht geschrieben werden ({reason_of}); einen anderen Ordner wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/serving.py" />
            <source>{path}: it can't be written ({reason}); free space there, or let it be written to</source>
            <translation>{path}: nicht schreibbar ({reason}); dort Platz schaffen oder das Schreiben erlauben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/table_file.py" />
            <source>{path}: it cannot be written ({reason}); choose another folder</source>
            <translation>{path}: Lässt sich nicht schreiben ({reason}); anderen Ordner wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/script.py" />
            <source>{path}: it has words without phones; name their language</source>
            <translation>{path}: Enthält Wörter ohne Laute; ihre Sprache angeben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/face_network.py" />
            <source>{path}: it is no network of a face, or damaged; learn one with `phonemeanalyser performance learn`</source>
            <translation>{path}: kein Netz eines Gesichts, oder beschädigt; mit `phonemeanalyser performance learn` eines lernen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/files.py" />
            <source>{path}: labels are written to .TextGrid, .txt (Audacity) and .csv files; choose such a name</source>
            <translation>{path}: Beschriftungen werden als .TextGrid, .txt (Audacity) oder .csv gespeichert; einen solchen Namen wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/files.py" />
            <source>{path}: there is no label to write; label something first</source>
            <translation>{path}: Keine Beschriftung zu schreiben; zuerst etwas beschriften</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/presets/files.py" />
            <source>{path}: there is no such preset; {words}</source>
            <translation>{path}: Dieses Preset fehlt; {words}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/style.py" />
            <source>{path}: there is no such style; {name}</source>
            <translation>{path}: Diesen Stil gibt es nicht; {name}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/takes/storage.py" />
            <source>{path}: this file cannot be renamed ({error}); close what uses it and try again</source>
            <translation>{path}: Diese Datei lässt sich nicht umbenennen ({error}); das Programm schließen, das sie benutzt, und erneut versuchen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/storage/files.py" />
            <source>{path}: this is no text file; choose {what}</source>
            <translation>{path}: Keine Textdatei; {what} wählen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/performance_model.py" />
            <source>{person} has no table, or several, in the language of the text; {table} moves the face.</source>
            <translation>{person} hat keine oder mehrere Tabellen in der Sprache des Textes; {table} bewegt das Gesicht.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/voice_panel.py" />
            <source>{person}, by the language of the text</source>
            <translation>{person}, nach der Sprache des Textes</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/mouth_table.py" />
            <source>{phoneme}: attack {attack} ms, release {release} ms</source>
            <translation>{phoneme}: Attack {attack} ms, Release {release} ms</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/takes/sentences.py" />
            <source>{phone} is no sound of the phonetic alphabet; spell the sentence with those of IPA</source>
            <translation>{phone} ist kein Laut der Lautschrift; den Satz mit IPA-Zeichen schreiben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/visemes.py" />
            <source>{phone} of the viseme {name} is no letter of the IPA; correct it</source>
            <translation>{phone} des Visems {name} ist kein IPA-Zeichen; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{place} cannot be served ({reason}); choose another host or port</source>
            <translation>{place} kann nicht bedient werden ({reason}); eine andere Adresse oder einen anderen Port wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/table.py" />
            <source>{place} has the shape {shape}, which [shapes] lacks; add it there</source>
            <translation>{place} hat die Mundform {shape}, die in [shapes] fehlt; dort hinzufügen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/x_file.py" />
            <source>{place}: a block is not closed; it is cut off, export it again</source>
            <translation>{place}: Ein Block ist nicht abgeschlossen; abgeschnitten, neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/x_file.py" />
            <source>{place}: a mesh has at most {most_triangles} triangles; make it coarser</source>
            <translation>{place}: Ein Mesh hat höchstens {most_triangles} Dreiecke; gröber machen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/x_file.py" />
            <source>{place}: expected a finite number, found {word}; export it again</source>
            <translation>{place}: Erwartet eine endliche Zahl, gefunden {word}; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/x_file.py" />
            <source>{place}: expected a whole number of 0..{most}, found {value}; export it again</source>
            <translation>{place}: Erwartet eine ganze Zahl 0..{most}, gefunden {value}; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/x_file.py" />
            <source>{place}: expected {word}, found {found}; export it again</source>
            <translation>{place}: Erwartet {word}, gefunden {found}; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/x_file.py" />
            <source>{place}: frames lie in more than {deepest} others; export it flatter</source>
            <translation>{place}: Frames sind tiefer als {deepest} verschachtelt; flacher exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/x_file.py" />
            <source>{place}: the faces of normals are not those of the mesh; export it again</source>
            <translation>{place}: Die Flächen der Normalen sind nicht die des Meshs; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/x_file.py" />
            <source>{place}: the mesh is not closed; it is cut off, export it again</source>
            <translation>{place}: Das Mesh ist nicht abgeschlossen; abgeschnitten, neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/takes/sentences.py" />
            <source>{place}: this folder cannot be made ({error}); choose another for the takes</source>
            <translation>{place}: Dieser Ordner lässt sich nicht anlegen ({error}); anderen für die Takes wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/x_file.py" />
            <source>{place}: {n} entries are announced, and there is space for {room}; export it again</source>
            <translation>{place}: {n} Einträge sind angekündigt, Platz ist für {room}; neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/lexicon.py" />
            <source>{place}: {word} has no IPA, found {unknown} in {ipa}; correct it</source>
            <translation>{place}: {word} ist nicht in IPA geschrieben, gefunden {unknown} in {ipa}; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/lexicon.py" />
            <source>{place}: {word} has no sounds, found {ipa}; write its IPA</source>
            <translation>{place}: {word} hat keine Laute, gefunden {ipa}; seine IPA angeben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/frame_views.py" />
            <source>{plot}: display gain</source>
            <translation>{plot}: Anzeigeverstärkung</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/storage/strict_table.py" />
            <source>{prefix}{key} must be {must}, found {value}; correct it</source>
            <translation>{prefix}{key} muss {must} sein, gefunden {value}; korrigieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/encoder/weights.py" />
            <source>{prefix}{name} has the shape {sizes}, that of Whisper base {shape}</source>
            <translation>{prefix}{name} hat die Form {sizes}, bei Whisper base ist sie {shape}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/encoder/weights.py" />
            <source>{prefix}{name} is missing</source>
            <translation>{prefix}{name} fehlt</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/encoder/weights.py" />
            <source>{prefix}{name} is neither float16 nor float32</source>
            <translation>{prefix}{name} ist weder float16 noch float32</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/preset_picker.py" />
            <source>{preset} (current settings)</source>
            <translation>{preset} (aktuelle Einstellungen)</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>{range} bands</source>
            <translation>{range} Bändern</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>{range} frames per second</source>
            <translation>{range} Bildern je Sekunde</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>{range} syllables per second</source>
            <translation>{range} Silben je Sekunde</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/page.py" />
            <source>{rate}/s</source>
            <translation>{rate}/s</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{recogniser} with a decoder, look-ahead {ms} ms</source>
            <translation>{recogniser} mit Decoder, Vorausschau {ms} ms</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{recogniser}, look-ahead {ms} ms</source>
            <translation>{recogniser}, Vorausschau {ms} ms</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>{recogniser}: no look-ahead</source>
            <translation>{recogniser}: keine Vorausschau</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/original_model.py" />
            <source>{recording}, original recording from {title}</source>
            <translation>{recording}, Originalaufnahme aus {title}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{rest}, only channel {k} of {n} is used</source>
            <translation>{rest}, nur Kanal {k} von {n} wird benutzt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{rest}, shorter than one window ({ms} ms), padded with silence</source>
            <translation>{rest}, kürzer als ein Fenster ({ms} ms), mit Stille aufgefüllt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{rest}, {n} channels are mixed to one</source>
            <translation>{rest}, {n} Kanäle zu einem gemischt</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/score_strip.py" />
            <source>{said} recognised as {recognised} for {seconds:.1f} s in total: go to an example</source>
            <translation>{said} als {recognised} erkannt, insgesamt {seconds:.1f} s: zu einem Beispiel springen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/confusion_view.py" />
            <source>{said} recognised as {taken}: {count} frames of 10 ms, {share:.1%} of {said}</source>
            <translation>{said} erkannt als {taken}: {count} Frames von 10 ms, {share:.1%} von {said}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/time_line.py" />
            <source>{said}; boundaries fixed by the voice</source>
            <translation>{said}; Grenzen von der Stimme vorgegeben</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/score_strip.py" />
            <source>{seconds:.1f} s labelled</source>
            <translation>{seconds:.1f} s beschriftet</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/status_line.py" />
            <source>{seconds:.2f} s lost</source>
            <translation>{seconds:.2f} s verloren</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/selection.py" />
            <source>{seconds:.2f} s of {path} saved as {target}</source>
            <translation>{seconds:.2f} s von {path} gespeichert als {target}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>{seconds:.2f} s, {n} frames</source>
            <translation>{seconds:.2f} s, {n} Frames</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/comparison.py" />
            <source>{seconds:.2f} s: {shapes}</source>
            <translation>{seconds:.2f} s: {shapes}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/words/time_line.py" />
            <source>{seconds:.2f} s: {word}</source>
            <translation>{seconds:.2f} s: {word}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/batch/record.py" />
            <source>{self}: what was done cannot be noted there ({error}); free some space, or choose another folder</source>
            <translation>{self}: Der Stand lässt sich dort nicht festhalten ({error}); Platz schaffen oder anderen Ordner wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/recording.py" />
            <source>{self}: {fault}; record or label it anew</source>
            <translation>{self}: {fault}; neu aufnehmen oder beschriften</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/file_view.py" />
            <source>{share:.1f} % different</source>
            <translation>{share:.1f} % verschieden</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/espeak.py" />
            <source>{short}: espeak-ng's data cannot be placed there ({error}); install the program in a folder with a shorter path</source>
            <translation>{short}: Die Daten von espeak-ng lassen sich dort nicht ablegen ({error}); Programm in einem Ordner mit kürzerem Pfad installieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/mesh.py" />
            <source>{size} vertices need positions of shape ({size_2}, 3), got {shape}</source>
            <translation>{size} Eckpunkte brauchen Positionen der Form ({size_2}, 3), gefunden {shape}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/takes/storage.py" />
            <source>{sound}: it cannot be removed ({error}); close what uses it and try again</source>
            <translation>{sound}: Lässt sich nicht löschen ({error}); das Programm schließen, das die Datei benutzt, und erneut versuchen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/takes/storage.py" />
            <source>{sound}: the take cannot be moved there ({error}); check the project's folder</source>
            <translation>{sound}: Der Take lässt sich nicht dorthin verschieben ({error}); Projektordner prüfen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/takes/storage.py" />
            <source>{sound}: there is another file of that name; move it out of the project</source>
            <translation>{sound}: Eine andere Datei dieses Namens ist vorhanden; aus dem Projekt verschieben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/scores/corpus.py" />
            <source>{source}: there is no such folder; name one with labelled recordings</source>
            <translation>{source}: Diesen Ordner gibt es nicht; einen mit beschrifteten Aufnahmen angeben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/scores/corpus.py" />
            <source>{source}: {fault}; put a .TextGrid, .csv or .txt file of the same name beside each sound</source>
            <translation>{source}: {fault}; neben jede Audiodatei eine gleichnamige .TextGrid-, .csv- oder .txt-Datei legen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/lanes/label_dialogs.py" />
            <source>{start:.2f} to {end:.2f} s: labelled {said}, recognised as {recognised}</source>
            <translation>{start:.2f} bis {end:.2f} s: beschriftet mit {said}, erkannt als {recognised}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/takes_panel.py" />
            <source>{start:.2f} – {end:.2f} s of {duration:.2f} s</source>
            <translation>{start:.2f} – {end:.2f} s von {duration:.2f} s</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{start} to {end} s of {sound}</source>
            <translation>{start} bis {end} s von {sound}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{start}, own voice, {day}: mouth shapes {before} to {after} % on held-out speech</source>
            <translation>{start}, eigene Stimme, {day}: Mundformen {before} auf {after} % mit zurückgehaltener Sprache</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{start}, own voice, {day}: mouth shapes {before} to {after} % on held-out speech, changed since</source>
            <translation>{start}, eigene Stimme, {day}: Mundformen {before} auf {after} % mit zurückgehaltener Sprache, seitdem geändert</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/utterance_edits.py" />
            <source>{strip} is no sound of IPA; write one, such as ə, or delete the phone</source>
            <translation>{strip} ist kein Laut der IPA; einen schreiben, etwa ə, oder das Phon löschen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/table.py" />
            <source>{table} knows no sound {key}; name a letter of the IPA without marks, or a class: {known}</source>
            <translation>{table} kennt keinen Laut {key}; IPA-Zeichen ohne Zusätze oder eine Klasse angeben: {known}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/performance_model.py" />
            <source>{table}: {note}.</source>
            <translation>{table}: {note}.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/drivers/performance_model.py" />
            <source>{table}: {note}; for {n} more notes, point at the caption below the head.</source>
            <translation>{table}: {note}; {n} weitere Hinweise zeigt der Tooltip der Zeile unter dem Kopf.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/takes/take_list.py" />
            <source>{take} is excluded: {reason}</source>
            <translation>{take} ist ausgeschlossen: {reason}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/storage/replacing.py" />
            <source>{target}: cannot be written ({error}); choose another place</source>
            <translation>{target}: Lässt sich nicht schreiben ({error}); anderen Ort wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/storage/replacing.py" />
            <source>{target}: the file that is there was made in another way, so it is left alone; choose another place, or replace it with --overwrite</source>
            <translation>{target}: Die vorhandene Datei entstand auf andere Weise und bleibt erhalten; anderen Ort wählen oder mit --overwrite ersetzen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/session/exports.py" />
            <source>{target}: {n} bytes of binary data</source>
            <translation>{target}: {n} Bytes Binärdaten</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/performance/own_sound.py" />
            <source>{tempfile}: what the sound is made of cannot be kept there ({error}); free some space</source>
            <translation>{tempfile}: Woraus der Ton besteht, lässt sich dort nicht speichern ({error}); Platz freigeben</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/speech/program.py" />
            <source>{template}: there is no speech in its sound; try it by itself</source>
            <translation>{template}: In der Audiodatei spricht niemand; für sich ausprobieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/utterance_edits.py" />
            <source>{text} can't be split at {seconds} s, in its first sound; go to the sound that the second word is to begin with</source>
            <translation>{text} lässt sich bei {seconds} s, in seinem ersten Laut, nicht teilen; zu dem Laut gehen, mit dem das zweite Wort beginnen soll</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/utterance_edits.py" />
            <source>{text} has no other sound; delete the word</source>
            <translation>{text} hat keinen anderen Laut; das Wort löschen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/utterance_edits.py" />
            <source>{text} is said from {start} to {end} s; delete it first, or go to a pause</source>
            <translation>{text} wird von {start} bis {end} s gesprochen; zuerst löschen oder zu einer Pause gehen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{trouble}; trying again every 2 s</source>
            <translation>{trouble}; neuer Versuch alle 2 s</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/widgets/file_asker.py" />
            <source>{url} cannot be opened, since only files on this computer can. Save it here first.</source>
            <translation>{url} lässt sich nicht öffnen, nur Dateien auf diesem Computer. Zuerst hier speichern.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{variable}, filtered</source>
            <translation>{variable}, gefiltert</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{variable}, mel</source>
            <translation>{variable}, Mel</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{variable}, raw</source>
            <translation>{variable}, roh</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/calibration/calibrate.py" />
            <source>{warnings}, and it alone learned the voice.</source>
            <translation>{warnings}; nur dieses hat die Stimme gelernt.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>{what} (at end of document)</source>
            <translation>{what} am Ende der Datei</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>{what} (at line {line}, column {column})</source>
            <translation>{what} in Zeile {line}, Spalte {column}</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/files/threedm.py" />
            <source>{what} is said to be {n}, and there is space for {room}; it is damaged, export it again</source>
            <translation>{what} ist mit {n} angegeben, Platz ist für {room}; beschädigt, neu exportieren</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/errors.py" />
            <source>{what} must lie in {limit}, got {value}; choose another value</source>
            <translation>{what} muss in {limit} liegen, gefunden {value}; anderen Wert wählen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/audio/containers.py" />
            <source>{what} needs the package av, which is not installed; install it with: pip install 'phonemeanalyser[media]'</source>
            <translation>{what} benötigt das Paket av, das nicht installiert ist; installieren mit: pip install 'phonemeanalyser[media]'</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>{what}, so nothing was recorded; {advice}</source>
            <translation>{what}, daher wurde nichts aufgenommen; {advice}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>{what}, so the recording stopped after {n} s, which are kept in {folder}; {advice}</source>
            <translation>{what}, daher endete die Aufnahme nach {n} s, die in {folder} liegen; {advice}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>{what}, so the recording stopped after {n} s, which are lost; {advice}</source>
            <translation>{what}, daher endete die Aufnahme nach {n} s, die verloren sind; {advice}</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_errors.py" />
            <source>{what}: line {line} column {column} (char {n})</source>
            <translation>{what} in Zeile {line}, Spalte {column} (Zeichen {n})</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>{what}; {percent:.0f} % measured</source>
            <translation>{what}; {percent:.0f} % gemessen</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{why}; until then the small network recognises live sound</source>
            <translation>{why}; bis dahin erkennt das kleine Netz den Live-Ton</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/engine_words.py" />
            <source>{why}; until then the small network recognises live sound, and it alone learned the voice.</source>
            <translation>{why}; bis dahin erkennt das kleine Netz den Live-Ton, und nur dieses hat die Stimme gelernt.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/mouth/expression/felt.py" />
            <source>{words} holds no number for {name}; write such as {name_2}=0.5</source>
            <translation>{words} enthält keine Zahl für {name}; etwa so schreiben: {name_2}=0.5</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/talk/expression/style_panel.py" />
            <source>{words}: write a number such as 0.5, or a shape such as jawOpen 5, mouthPress 30.</source>
            <translation>{words}: Eine Zahl wie 0.5 schreiben oder eine Form wie jawOpen 5, mouthPress 30.</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/batch/runner.py" />
            <source>{words}; the disk is full, so the batch ends here: free some space, and start it again, which goes on where it was</source>
            <translation>{words}; das Laufwerk ist voll, daher endet der Stapel hier: Platz schaffen und neu starten, er macht dann hier weiter</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/text/feelings.py" />
            <source>{word} is called both good and bad; name it once</source>
            <translation>{word} ist als gut und als schlecht eingetragen; nur einmal eintragen</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/pinyin.py" />
            <source>{written} has more than one tone; write a syllable of pinyin such as hao3</source>
            <translation>{written} hat mehr als einen Ton; eine Pinyin-Silbe schreiben wie hao3</translation>
        </message>
        <message>
            <location filename="../../../engine/phonemeengine/labels/pinyin.py" />
            <source>{written} is no syllable of pinyin; write one such as hao3 or lü4</source>
            <translation>{written} ist keine Pinyin-Silbe; eine schreiben wie hao3 oder lü4</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>Δ in dB between the first {n} shown curves</source>
            <translation>Δ in dB zwischen den ersten {n} angezeigten Kurven</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>Δ in dB between the shown curves</source>
            <translation>Δ in dB zwischen den angezeigten Kurven</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/spectra/curve_panel.py" />
            <source>Δ: root-mean-square difference of two spectra in dB, independent of loudness (the mean difference is taken away). The measure is d2 of Gray and Markel, IEEE Trans. ASSP 24(5), 1976.</source>
            <translation>Δ: quadratisches Mittel des Unterschieds zweier Spektren in dB, unabhängig von der Lautstärke (der mittlere Unterschied wird abgezogen). Es ist das Maß d2 von Gray und Markel, IEEE Trans. ASSP 24(5), 1976.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/variable_panel.py" />
            <source>–</source>
            <translation>–</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/workbench/phoneme_data_model.py" />
            <source>“{name}” does not use these numbers. Choose the preset “Thesis”.</source>
            <translation>„{name}“ verwendet diese Zahlen nicht. Das Preset „Thesis“ wählen.</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/analyse/recognition/filter_column.py" />
            <source>“{name}” uses the unfiltered signal; filters affect the display only</source>
            <translation>„{name}“ nutzt das ungefilterte Signal; Filter wirken nur auf die Anzeige</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>▶ New preset</source>
            <translation>▶ Neues Preset</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>▶ Old preset</source>
            <translation>▶ Altes Preset</translation>
        </message>
        <message>
            <location filename="../../../phonemeanalyser/desktop/calibrate/guide/guide_view.py" />
            <source>◀ Back</source>
            <translation>◀ Zurück</translation>
        </message>
    </context>
</TS>
