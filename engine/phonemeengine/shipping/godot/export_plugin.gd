# SPDX-License-Identifier: MIT
@tool
extends EditorExportPlugin
## Puts presets of this folder into an exported program; libraries come along by themselves.


func _get_name() -> String:
	return "phoneme_ear"


func _export_begin(_features: PackedStringArray, _debug: bool, _path: String, _flags: int) -> void:
	var folder: String = (get_script() as Script).resource_path.get_base_dir()
	for file in DirAccess.get_files_at(folder):
		if file.get_extension() == "ear":
			var path := folder.path_join(file)
			add_file(path, FileAccess.get_file_as_bytes(path), false)
