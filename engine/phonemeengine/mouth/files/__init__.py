"""Files of meshes and movestates, each format in a file of its own; `io` chooses by a file's ending."""
