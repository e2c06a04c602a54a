"""A speech encoder that learned from very many speakers: its states, and the head that names phonemes from them."""
