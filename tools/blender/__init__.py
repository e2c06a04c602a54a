"""The add-on for Blender, and what makes its zip."""
