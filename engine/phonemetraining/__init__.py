"""The training of the learned recogniser, from labelled speech to a model and its card.

It stands on `phonemeengine`, which knows nothing of it: a program that recognises loads none of it. The way through
it is `phonemetraining.pipeline.train_and_validate`, which ``phonemeanalyser train`` calls.
"""
