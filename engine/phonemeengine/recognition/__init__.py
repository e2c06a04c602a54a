"""Evidence becomes a name: recognisers, and the smoothing of what they name."""
