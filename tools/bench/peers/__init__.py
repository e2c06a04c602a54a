"""Other recognisers beside ours, on the same labelled recordings: `python -m tools.bench.peers` prints the table."""
