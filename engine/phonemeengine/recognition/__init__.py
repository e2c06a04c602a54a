"""Evidence becomes a name: recognisers, and the statistics that calm them."""
