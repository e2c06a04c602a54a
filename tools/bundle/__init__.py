"""The program that needs no Python: ``make bundle``."""
