# SPDX-License-Identifier: MIT
extends Node
## Prints phonemes and visemes of the microphone. Needs the bus Voice with the effect Capture, and
## Audio > Driver > Enable Input in the project's settings.


func _ready() -> void:
	var microphone := AudioStreamPlayer.new()
	microphone.stream = AudioStreamMicrophone.new()
	microphone.bus = "Voice"
	add_child(microphone)
	microphone.play()
	var listener := PhonemeListener.new()
	listener.phoneme_changed.connect(func(phoneme: String) -> void: print("phoneme ", phoneme))
	listener.viseme_changed.connect(func(viseme: String) -> void: print("viseme ", viseme))
	add_child(listener)
