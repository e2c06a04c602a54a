"""Very many files: on all cores or a cluster, each output whole or not there, and nothing done twice."""
