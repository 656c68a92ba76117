// The light of many points around c, at points p that are nearer to c than any of them. Without the cosine's clamp, a lamp at l gives a surface n.V, where
// V = (l - p) / |l - p|^3 is the slope of 1 / |l - p|, in p. With u = p - c and d = |l - c| that is a sum over n from 0 on of
// |u|^n / d^(n + 1) P_n(cos(u, l - c)), and P_n a sum of products of 2 n + 1 harmonics of each direction: so lamps add up in their harmonics alone.
// FAR_TERMS are those of n = 1 to 4. What is left out: the slope of |u|^n P_n is at most n |u|^(n - 1) (Bernstein's and Szego's inequality for P_n as
// a polynomial of the angle's cosine), and with q = |u| / d the sum of n q^(n - 1) from n = 5 on is q^4 (5 - 4 q) / (1 - q)^2, times 1 / d^2.
// For example a lamp at (0, 0, 2), u = (0, 0, 1), n = (0, 0, 1): 1 is the truth, and 1/4 (1 + 2/2 + 3/4 + 4/8) = 0.8125; left out is 0.1875, and the
// bound says (5 - 2) / 16 / (1/4) / 4 = 0.1875: so it is met where all lie on one line.
#define FAR_TERMS 24
// By name: a loop that some compiler leaves as it is would keep an array in memory.
#define FAR_EACH(f)                                                                                                    \
    f(0) f(1) f(2) f(3) f(4) f(5) f(6) f(7) f(8) f(9) f(10) f(11) f(12) f(13) f(14) f(15) f(16) f(17) f(18) f(19)      \
        f(20) f(21) f(22) f(23)
#define FAR_EACH_LOBE(f) f(0) f(1) f(2) f(3) f(4) f(5) f(6)

// A lamp that gives `power` at c, from the direction w, where the greatest |u| is `ratio` of its distance.
void farAdd(vec3 w, float ratio, vec3 power, inout vec3 sums[FAR_TERMS])
{
    float x = w.x, y = w.y, z = w.z, xx = x * x, yy = y * y, zz = z * z, a = xx + yy, b = xx - yy, xy = x * y;
    vec3 p = power;
    sums[0] += p * x;
    sums[1] += p * y;
    sums[2] += p * z;
    p *= ratio;
    sums[3] += p * (zz - 0.5 * a);
    sums[4] += p * (1.7320508 * x * z);
    sums[5] += p * (1.7320508 * y * z);
    sums[6] += p * (0.8660254 * b);
    sums[7] += p * (1.7320508 * xy);
    p *= ratio;
    float c = x * (xx - 3.0 * yy), s = y * (3.0 * xx - yy);
    sums[8] += p * (z * (zz - 1.5 * a));
    sums[9] += p * (0.6123724 * x * (4.0 * zz - a));
    sums[10] += p * (0.6123724 * y * (4.0 * zz - a));
    sums[11] += p * (1.9364917 * z * b);
    sums[12] += p * (3.8729833 * z * xy);
    sums[13] += p * (0.7905694 * c);
    sums[14] += p * (0.7905694 * s);
    p *= ratio;
    sums[15] += p * (zz * (zz - 3.0 * a) + 0.375 * a * a);
    sums[16] += p * (0.7905694 * x * z * (4.0 * zz - 3.0 * a));
    sums[17] += p * (0.7905694 * y * z * (4.0 * zz - 3.0 * a));
    sums[18] += p * (0.5590170 * b * (6.0 * zz - a));
    sums[19] += p * (1.1180340 * xy * (6.0 * zz - a));
    sums[20] += p * (2.0916501 * z * c);
    sums[21] += p * (2.0916501 * z * s);
    sums[22] += p * (0.7395100 * (x * c - y * s));
    sums[23] += p * (2.9580399 * xy * b);
}

// The harmonics' slopes along n, at u, which is of length 1 at most.
void farSlopes(vec3 u, vec3 n, out float slopes[FAR_TERMS])
{
    float x = u.x, y = u.y, z = u.z, xx = x * x, yy = y * y, zz = z * z, a = xx + yy, b = xx - yy, xy = x * y;
    float c = x * (xx - 3.0 * yy), s = y * (3.0 * xx - yy);
    float da = 2.0 * (x * n.x + y * n.y), db = 2.0 * (x * n.x - y * n.y), dxy = n.x * y + x * n.y; // slopes of a, b, xy
    float dc = 3.0 * (b * n.x - 2.0 * xy * n.y), ds = 3.0 * (2.0 * xy * n.x + b * n.y);           // and of c, s
    slopes[0] = n.x;
    slopes[1] = n.y;
    slopes[2] = n.z;
    slopes[3] = 2.0 * z * n.z - 0.5 * da;
    slopes[4] = 1.7320508 * (n.x * z + x * n.z);
    slopes[5] = 1.7320508 * (n.y * z + y * n.z);
    slopes[6] = 0.8660254 * db;
    slopes[7] = 1.7320508 * dxy;
    float e = 4.0 * zz - a, de = 8.0 * z * n.z - da;
    slopes[8] = n.z * (3.0 * zz - 1.5 * a) - 1.5 * z * da;
    slopes[9] = 0.6123724 * (n.x * e + x * de);
    slopes[10] = 0.6123724 * (n.y * e + y * de);
    slopes[11] = 1.9364917 * (n.z * b + z * db);
    slopes[12] = 3.8729833 * (n.z * xy + z * dxy);
    slopes[13] = 0.7905694 * dc;
    slopes[14] = 0.7905694 * ds;
    float f = z * (4.0 * zz - 3.0 * a), df = n.z * (12.0 * zz - 3.0 * a) - 3.0 * z * da;
    float g = 6.0 * zz - a, dg = 12.0 * z * n.z - da;
    slopes[15] = n.z * z * (4.0 * zz - 6.0 * a) + da * (0.75 * a - 3.0 * zz);
    slopes[16] = 0.7905694 * (n.x * f + x * df);
    slopes[17] = 0.7905694 * (n.y * f + y * df);
    slopes[18] = 0.5590170 * (db * g + b * dg);
    slopes[19] = 1.1180340 * (dxy * g + xy * dg);
    slopes[20] = 2.0916501 * (n.z * c + z * dc);
    slopes[21] = 2.0916501 * (n.z * s + z * ds);
    slopes[22] = 0.7395100 * (n.x * c + x * dc - n.y * s - y * ds);
    slopes[23] = 2.9580399 * (dxy * b + xy * db);
}
