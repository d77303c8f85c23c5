/*
 * The same k as batches, as an engineer writes them who knows the answer and the processor:
 * AVX-512, one sine and cosine for each angle, eight poses at once (n is a multiple of 8).
 */
#include <immintrin.h>
#include <math.h>
#include <stddef.h>

typedef __m512d Eight;
typedef const double *Column;

static inline Eight all(double x) { return _mm512_set1_pd(x); }

static inline Eight horner(Eight z, const double *coefficients, int count)
{
    Eight sum = all(coefficients[0]);
    for (int i = 1; i < count; ++i) {
        sum = _mm512_fmadd_pd(z, sum, all(coefficients[i]));
    }
    return sum;
}

static inline void turn(Eight x, Eight *sine, Eight *cosine)
{
    static const double odd[] = {1.58969099521155010221e-10, -2.50507602534068634195e-08,
        2.75573137070700676789e-06, -1.98412698298579493134e-04, 8.33333333332248946124e-03,
        -1.66666666666666324348e-01};
    static const double even[] = {-1.13596475577881948265e-11, 2.08757232129817482790e-09,
        -2.75573143513906633035e-07, 2.48015872894767294178e-05, -1.38888888888741095749e-03,
        4.16666666666666019037e-02};
    const Eight turns = _mm512_roundscale_pd(_mm512_mul_pd(x, all(0.63661977236758138)), 8);
    Eight r = _mm512_fnmadd_pd(turns, all(1.57079632679489655800e+00), x);
    r = _mm512_fnmadd_pd(turns, all(6.12323399573676603587e-17), r);
    const Eight z = r*r;
    const Eight s = _mm512_fmadd_pd(z*r, horner(z, odd, 6), r);
    const Eight c = _mm512_fmadd_pd(z*z, horner(z, even, 6), _mm512_fnmadd_pd(z, all(0.5), all(1.0)));
    const __m512i quarter = _mm512_cvtpd_epi64(turns), two = _mm512_set1_epi64(2);
    const __mmask8 swap = _mm512_test_epi64_mask(quarter, _mm512_set1_epi64(1));
    const __m512i next = _mm512_add_epi64(quarter, _mm512_set1_epi64(1));
    const __m512i below = _mm512_slli_epi64(_mm512_and_epi64(quarter, two), 62);
    const __m512i left = _mm512_slli_epi64(_mm512_and_epi64(next, two), 62);
    *sine = (Eight)_mm512_xor_si512((__m512i)_mm512_mask_blend_pd(swap, s, c), below);
    *cosine = (Eight)_mm512_xor_si512((__m512i)_mm512_mask_blend_pd(swap, c, s), left);
}

#define AT(column) _mm512_loadu_pd((column) + i)
#define EACH for (size_t i = 0; i < n; i += 8)

void crank_slider_by_hand(size_t n, Column r, Column phi, Column beta, double *k)
{
    EACH {
        Eight sine, cosine, other, below;
        turn(AT(phi) + AT(beta), &sine, &cosine);
        turn(AT(beta), &other, &below);
        _mm512_storeu_pd(k + i, AT(r)*sine/below);
    }
}

void karpenko_fig9_packet_clamp_by_hand(
    size_t n, Column a, Column b, Column alpha, Column beta, double *k)
{
    EACH {
        Eight s, c, t, d;
        turn(AT(alpha), &s, &c);
        turn(AT(beta), &t, &d);
        _mm512_storeu_pd(k + i, AT(a)*(s*d + c*t)/(2.0*AT(b)*c*d));
    }
}

void crank_rocker_by_hand(
    size_t n, Column a, Column b, Column c, Column d, Column phi, double *k)
{
    EACH {
        Eight s, t;
        turn(AT(phi), &s, &t);
        const Eight ay = AT(a)*s, ux = AT(d) - AT(a)*t, square = ux*ux + ay*ay;
        const Eight m = AT(b)*AT(b) - AT(c)*AT(c) + square;
        const Eight across = _mm512_sqrt_pd(4.0*AT(b)*AT(b)*square - m*m);
        const Eight x = ux*m + ay*across, y = ux*across - ay*m;
        _mm512_storeu_pd(k + i, AT(a)*AT(c)*(x*s - y*t)/(square*across));
    }
}

void watt_closed_by_hand(
    size_t n, Column a, Column b, Column c, Column e, Column l, Column g, Column phi, double *k)
{
    const double turned = 40.0*3.14159265358979323846/180.0;
    const double right = cos(turned), up = sin(turned);
    EACH {
        Eight s, t;
        turn(AT(phi), &s, &t);
        const Eight ax = AT(a)*t, ay = AT(a)*s, ux = 0.1 - ax, uy = -ay, square = ux*ux + uy*uy;
        const Eight m = AT(b)*AT(b) - AT(c)*AT(c) + square, half = 0.5/square;
        const Eight across = _mm512_sqrt_pd(4.0*AT(b)*AT(b)*square - m*m);
        const Eight bx = (m*ux - across*uy)*half, by = (m*uy + across*ux)*half;
        const Eight ox = bx - ux, oy = by - uy, scale = AT(e)/AT(c);
        const Eight cx = scale*(ox*right - oy*up), cy = scale*(oy*right + ox*up);
        const Eight vx = 0.1 - cx, vy = 0.02 - cy, square_2 = vx*vx + vy*vy;
        const Eight m_2 = AT(l)*AT(l) - AT(g)*AT(g) + square_2, half_2 = 0.5/square_2;
        const Eight across_2 = _mm512_sqrt_pd(4.0*AT(l)*AT(l)*square_2 - m_2*m_2);
        const Eight dx = (m_2*vx - across_2*vy)*half_2, dy = (m_2*vy + across_2*vx)*half_2;
        const Eight px = dx - vx, py = dy - vy;
        _mm512_storeu_pd(k + i, AT(g)*(ax*by - ay*bx)*(cx*dy - cy*dx)
            /((ox*by - oy*bx)*(px*dy - py*dx)));
    }
}
