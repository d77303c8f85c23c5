"""Equilibrium by hand: sums of forces and moments, body by body, as a course in statics asks.

Of virtual power it knows the mechanism, its pose and its degrees of freedom, and no velocity.
``actions`` says how links and pins are cut free, what acts on one, and which sums may be written of
it; ``exerted`` what joints and loads do to them, which ``bodies`` gathers body by body.
``order`` chooses the sums that give one force after another, ``at_joints`` says what a force at
a joint is the sum of, ``from_plan`` does all of it for each load: ``equilibrium`` is that as data.

Promises: every sum holds for any values of its symbols, those of closed loops as they
close; each step has as many sums as it finds forces, and rests on loads and on what
earlier steps have found; nothing is found that the load does not rest on.
"""
