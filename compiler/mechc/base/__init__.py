"""What the standard library has, without what it costs at each start: classes, kinds, imports.

``frozen`` are data classes, ``named`` tuples with named fields, ``string_enum`` kinds that are
words; ``later`` puts off imports and regular expressions until they are needed.
"""
