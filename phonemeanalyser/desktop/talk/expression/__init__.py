"""Expressions from sliders, recordings and OSC."""
