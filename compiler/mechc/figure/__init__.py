"""The figure: where every point is at a pose, and what is drawn there.

``from_pose`` makes it, ``figure`` is it as data. ``linear_vectors`` are the vectors it is put
together from, ``lengths`` chooses those that nothing gives, ``layout`` puts every point in its
place. ``half`` is one half of what is mirrored; ``joints``, ``outline`` (bodies), ``wheels`` and
``dimensions`` are what is drawn; ``from_balance`` adds ``velocities``.

Whoever draws needs nothing but the figure: no angle algebra, no parameters, no second half to be
made up.
"""
