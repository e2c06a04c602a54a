# SPDX-License-Identifier: MIT
@tool
extends EditorPlugin
## Has the export of a game take presets and libraries along.

const Exporter := preload("export_plugin.gd")

var _exporter: EditorExportPlugin


func _enter_tree() -> void:
	_exporter = Exporter.new()
	add_export_plugin(_exporter)


func _exit_tree() -> void:
	remove_export_plugin(_exporter)
