# SPDX-License-Identifier: MIT
@tool
extends EditorExportPlugin
## Puts the system's library beside the exported program, and presets of this folder into it.

const LIBRARIES := {"windows": "ear.dll", "linux": "libear.so", "macos": "libear.dylib"}


func _get_name() -> String:
	return "phoneme_ear"


func _export_begin(features: PackedStringArray, _debug: bool, _path: String, _flags: int) -> void:
	var folder: String = (get_script() as Script).resource_path.get_base_dir()
	for system: String in LIBRARIES:
		if system in features:
			add_shared_object(folder.path_join(LIBRARIES[system]), PackedStringArray(), "")
	for file in DirAccess.get_files_at(folder):
		if file.get_extension() == "ear":
			var path := folder.path_join(file)
			add_file(path, FileAccess.get_file_as_bytes(path), false)
