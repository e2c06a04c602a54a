# SPDX-License-Identifier: MIT
@icon("icons/phoneme_sprite.svg")
class_name PhonemeSprite
extends PhonemeListener
## Shows the drawing of a mouth for what is recognised: the animation with the name of its shape.

## A sprite with an animation for each shape of the table, such as B.
@export var sprite: AnimatedSprite2D


func _init() -> void:
	table = "rhubarb"


func _open() -> String:
	if sprite == null:
		return "it has no sprite; choose an AnimatedSprite2D"
	shape_changed.connect(_show)
	return super()


func _show(name_of_shape: String) -> void:
	if sprite.sprite_frames.has_animation(name_of_shape):
		sprite.animation = name_of_shape
