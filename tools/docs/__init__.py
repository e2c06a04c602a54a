"""What the build of the documentation needs: `make docs`."""
