/*
 * What an engineer writes who knows the answer: coordinates, cross products, one square
 * root for each triangle, and no angle but the drive. The lengths are arguments, as in
 * the emitted functions, and in their order.
 */
#include <math.h>

/* Couple on the crank over the force across the rocker at its end. */
double crank_rocker_by_hand(double a, double b, double c, double d, double phi)
{
    const double ax = a*cos(phi), ay = a*sin(phi);
    const double ux = d - ax, uy = -ay; /* A to O2 */
    const double square = ux*ux + uy*uy;
    const double along = (b*b - c*c + square)/(2.0*square);
    const double across = sqrt(b*b/square - along*along);
    const double bx = along*ux - across*uy, by = along*uy + across*ux; /* A to B */
    const double ox = bx - ux, oy = by - uy;                           /* O2 to B */
    return c*(ay*bx - ax*by)/(bx*oy - by*ox);
}

/* Two four-bars in a row; the second is driven by a corner of the first one's rocker. */
double watt_closed_by_hand(
    double a, double b, double c, double e, double l, double g, double phi)
{
    const double turn = 40.0*3.14159265358979323846/180.0, scale = e/c;
    const double ax = a*cos(phi), ay = a*sin(phi);
    const double ux = 0.1 - ax, uy = -ay; /* A to O2 */
    const double square = ux*ux + uy*uy;
    const double along = (b*b - c*c + square)/(2.0*square);
    const double across = sqrt(b*b/square - along*along);
    const double bx = along*ux - across*uy, by = along*uy + across*ux; /* A to B */
    const double ox = bx - ux, oy = by - uy;                           /* O2 to B */
    const double cx = scale*(ox*cos(turn) - oy*sin(turn));             /* O2 to C */
    const double cy = scale*(oy*cos(turn) + ox*sin(turn));
    const double vx = 0.1 - cx, vy = 0.02 - cy; /* C to O3 */
    const double square_2 = vx*vx + vy*vy;
    const double along_2 = (l*l - g*g + square_2)/(2.0*square_2);
    const double across_2 = sqrt(l*l/square_2 - along_2*along_2);
    const double dx = along_2*vx - across_2*vy, dy = along_2*vy + across_2*vx; /* C to D */
    const double px = dx - vx, py = dy - vy;                                   /* O3 to D */
    return g*(ax*by - ay*bx)*(cx*dy - cy*dx)/((ox*by - oy*bx)*(px*dy - py*dx));
}
