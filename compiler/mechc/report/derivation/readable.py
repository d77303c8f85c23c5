"""How a derivation's formulas are turned to be read, term by term with those of its results."""

from collections.abc import Iterable, Sequence

from ...base.frozen import replace
from ...formula.differences import factors_as_in, terms_as_in
from ...formula.layout import has_minus
from ...formula.rewriting import plus_first
from ...formula.tree import Formula, Product, negative
from ..readable import ReadableFormulas
from ..steps import Derivation, DerivationStep, Equation, Explanation, LastStep, Paragraph


class ReadableDerivation(ReadableFormulas):
    """Writes the formulas of derivations as those of results."""

    def with_fewest_minuses(self, equation: Equation) -> Equation:
        """Return an equation with readable sides, all of the other sign if fewer have a minus then.

        Of sums of forces and moments the signs have a meaning; velocities have none.
        """
        sides = Equation(*map(self.of, equation))
        if not any(isinstance(side, Product) and has_minus(side) for side in sides):
            return sides
        opposite = Equation(*(self.of(negative(side)) for side in sides))
        return min(sides, opposite, key=lambda pair: sum(map(has_minus, pair)))

    def equations(self, equations: Iterable[Equation]) -> tuple[Equation, ...]:
        """Return equations, either side of each by itself."""
        return tuple(Equation(*map(self.of, equation)) for equation in equations)

    def step(self, step: DerivationStep, sines: Sequence[Formula]) -> DerivationStep:
        """Return a step of the velocities; what it finds has the sines that results have."""
        relations = tuple(map(self.with_fewest_minuses, step.relations))
        results = self.equations(step.results)
        found = (e._replace(right=factors_as_in(e.right, *sines)) for e in results)
        return replace(step, relations=relations, results=tuple(found))

    def explanation(self, explanation: Explanation, sines: Sequence[Formula]) -> Explanation:
        """Return how a force follows, term by term with the sines that results have."""

        def side(formula: Formula) -> Formula:
            return plus_first(terms_as_in(self.of(formula, longer=1), *sines))

        def shown(paragraph: Paragraph) -> Paragraph:
            equations = (Equation(*map(side, equation)) for equation in paragraph.equations)
            return replace(paragraph, equations=tuple(equations))

        return replace(explanation, paragraphs=tuple(map(shown, explanation.paragraphs)))

    def last_step(self, step: LastStep) -> LastStep:
        """Return the step that gives a ratio."""
        ratio = step.ratio._replace(right=self.of(step.ratio.right))
        chain = step.chain and step.chain._replace(product=self.of(step.chain.product))
        return LastStep(chain, ratio)

    def derivation(self, derivation: Derivation) -> Derivation:
        """Return the steps with sines of differences turned as those of the results are."""
        results = self.results(derivation.results)
        sines = self.sines(result.formula for result in results)
        return replace(
            derivation,
            results=results,
            steps=tuple(self.step(step, sines) for step in derivation.steps),
            balances=self.equations(derivation.balances),
            explanations=tuple(self.explanation(e, sines) for e in derivation.explanations),
            ratios=tuple(r._replace(formula=self.of(r.formula)) for r in derivation.ratios),
        )
