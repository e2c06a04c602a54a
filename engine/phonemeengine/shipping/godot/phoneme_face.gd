# SPDX-License-Identifier: MIT
@icon("icons/phoneme_face.svg")
class_name PhonemeFace
extends PhonemeListener
## Moves the blend shapes of a mesh by what is recognised.

## A mesh with blend shapes of the table's names.
@export var face: MeshInstance3D

var _targets := PackedInt32Array()  # for each movestate: the blend shape, or -1


func _process(delta: float) -> void:
	super(delta)
	var weights := get_weights()
	for k in _targets.size():
		if _targets[k] >= 0:
			face.set_blend_shape_value(_targets[k], weights[k])


func _open() -> String:
	if face == null:
		return "it has no face; choose a MeshInstance3D with blend shapes"
	var wrong := super()
	for movestate in get_movestates():
		_targets.append(face.find_blend_shape_by_name(movestate))
	if _targets.size() > 0 and _targets.count(-1) == _targets.size():
		var words := "%s: it has no blend shape of the table %s, such as %s"
		push_warning(words % [face.name, table, get_movestates()[0]])
	return wrong
