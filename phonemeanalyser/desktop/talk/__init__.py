"""The Talk page: a head that speaks what is playing."""
