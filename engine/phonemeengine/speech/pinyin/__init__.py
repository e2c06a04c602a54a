"""The pinyin mouth: Mandarin text moves a mouth by two letters a syllable."""
