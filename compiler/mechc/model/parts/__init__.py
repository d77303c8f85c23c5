"""What a mechanism is made of: bodies and joints, loads, friction, quantities, what is asked for.

Promises: frozen values in SI, which ``mechanism`` hands on; nothing here reads a description.
"""
