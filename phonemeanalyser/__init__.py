"""The desktop tool."""
