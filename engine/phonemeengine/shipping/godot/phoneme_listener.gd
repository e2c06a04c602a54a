# SPDX-License-Identifier: MIT
@icon("icons/phoneme_listener.svg")
class_name PhonemeListener
extends Node
## Recognises the speech of an audio bus that has the effect Capture: of a microphone, or a voice.

## Another phoneme is recognised, such as "a"; and another viseme, such as "aa".
signal phoneme_changed(phoneme: String)
signal viseme_changed(viseme: String)
## Another mouth shape of the table is to be shown, such as "B".
signal shape_changed(shape: String)

## An .ear file.
@export_file("*.ear") var preset := "res://addons/phoneme_ear/preset.ear"
## The bus with the effect Capture.
@export var bus := "Voice"
## A mouth table that was shipped with the preset.
@export var table := "arkit"

## What was recognised last: names, how loud (0..1), and the share of such answers that are right
## (NaN where the preset has no such curve).
var phoneme := ""
var viseme := ""
var shape := ""
var intensity := 0.0
var confidence := NAN
## Seconds of the sound at which it was recognised.
var time := 0.0

var _recogniser: PhonemeRecogniser
var _capture: AudioEffectCapture


func _ready() -> void:
	var wrong := _open()
	if wrong:
		push_error("%s: %s" % [name, wrong])
		set_process(false)


func _process(_delta: float) -> void:
	var n := _capture.get_frames_available()
	if n > 0:
		for frame in _recogniser.push(_capture.get_buffer(n)):
			_hear(frame)


## The names of the blend shapes, in the order of [method get_weights].
func get_movestates() -> PackedStringArray:
	return _recogniser.get_movestates() if _recogniser else PackedStringArray()


## How far each blend shape is moved now, 0..1; the mouth moves smoothly.
func get_weights() -> PackedFloat32Array:
	return _recogniser.get_weights(time) if _recogniser else PackedFloat32Array()


func _open() -> String:
	var number := AudioServer.get_bus_index(bus)
	for k in AudioServer.get_bus_effect_count(number) if number >= 0 else 0:
		if AudioServer.get_bus_effect(number, k) is AudioEffectCapture:
			_capture = AudioServer.get_bus_effect(number, k)
	if _capture == null:
		return "there is no bus %s with the effect Capture; add them in the Audio panel" % bus
	var content := FileAccess.get_file_as_bytes(preset)
	if content.is_empty():
		return "%s cannot be read; check its name, and that *.ear is exported" % preset
	_recogniser = PhonemeRecogniser.new()
	_capture.clear_buffer()
	return _recogniser.open(content, int(AudioServer.get_mix_rate()), table)


func _hear(frame: int) -> void:
	time = _recogniser.get_time(frame)
	intensity = _recogniser.get_intensity(frame)
	confidence = _recogniser.get_confidence(frame)
	if phoneme != _recogniser.get_phoneme(frame):
		phoneme = _recogniser.get_phoneme(frame)
		phoneme_changed.emit(phoneme)
	if viseme != _recogniser.get_viseme(frame):
		viseme = _recogniser.get_viseme(frame)
		viseme_changed.emit(viseme)
	if shape != _recogniser.get_shape(frame):
		shape = _recogniser.get_shape(frame)
		shape_changed.emit(shape)
