#!/usr/bin/env python3
"""oblique_impacts.py -- oblique and spinning impacts of a sphere on a rigid plane, integrated
without Suna: writes chung_ooi.csv.

The sets are tests 4, 5 and 6 of Chung and Ooi, Granul. Matter 13 (2011) 643. A sphere of radius R
meets a plane that stays where it is, so the motion has one normal and one tangential direction and
is integrated as it stands (velocity Verlet, 20000 steps in the time of an elastic impact):

    F_n = k_n d - eta u                 k_n = 4/3 E sqrt(R d) or given        u: rate of the gap, d: overlap
    F_t = -k_t xi - eta dxi/dt          k_t = 8 G sqrt(R d), or 2/7 k_n; dxi/dt = s where that holds. Where |F_t| would pass
                                        mu max(F_n, 0) it is that, and xi is left to dxi/dt = (-F_t - k_t xi)/eta, each
                                        step by its exponential; what is left of s slips. Without eta xi = -F_t/k_t
    s   = v - (R - d) w                 the point of contact lies on the plane
    eta = alpha sqrt(m k_n)             sqrt(5) or 2 times -ln e/sqrt(pi^2 + ln^2 e), Hertz or linear

Laws: 1 mindlin (xi is kept while k_t changes), 2 mindlinIncremental (the force is kept while
pressed, xi while parting), 3 linear. Contact ends when d = 0; the pull at its end counts in F_n,
not in the limit of friction.

    python3 oblique_impacts.py > chung_ooi.csv

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math

STEPS = 20000


def impact(law, R, rho, E, nu, mu, e, vn, vt, w, speed):
    """Returns normal speed, tangential speed and spin after the impact; `speed` sets the stiffness
    of the linear spring."""
    m = 4/3*math.pi*R**3*rho
    inertia = 0.4*m*R*R
    E_star = E/(1 - nu*nu)
    G_star = E/(2*(2 - nu)*(1 + nu))
    deepest = (15*m*speed*speed/(16*E_star*math.sqrt(R)))**0.4
    k = m*(speed/deepest)**2
    log = math.log(e)
    alpha = -log/math.sqrt(math.pi**2 + log*log)*(2 if law == 3 else math.sqrt(5))
    duration = math.pi*math.sqrt(m/k) if law == 3 else 2.8682656992*(m*m/(R*E_star*E_star*vn))**0.2
    dt = duration/STEPS

    d, u, xi, before = 0.0, -vn, 0.0, 0.0

    def force(d, u, xi, s, dt):
        if law == 3:
            kn, kt = k, 2/7*k
        else:
            root = math.sqrt(R*d)
            kn, kt = 4/3*E_star*root, 8*G_star*root
        eta = alpha*math.sqrt(m*kn)
        fn = kn*d - eta*u
        if law == 2 and before < kt:
            xi *= before/kt
        ft = -kt*(xi + dt*s) - eta*s
        most = mu*max(fn, 0.0)
        if abs(ft) <= most:
            return fn, ft, xi + dt*s, kt
        ft = math.copysign(most, ft)
        rest = -ft/kt if kt > 0 else 0.0
        fades = math.exp(-kt*dt/eta) if eta > 0 and most > 0 else 0.0
        return fn, ft, rest + (xi - rest)*fades, kt

    fn, ft, _, _ = force(0.0, u, 0.0, vt - R*w, 0.0)
    while True:
        u += 0.5*dt*fn/m
        vt += 0.5*dt*ft/m
        w -= 0.5*dt*ft*(R - d)/inertia
        d -= dt*u
        if d <= 0.0:
            return u, vt, w
        s = vt - (R - d)*w
        fn, ft, xi, before = force(d, u, xi, s, dt)
        u += 0.5*dt*fn/m
        vt += 0.5*dt*ft/m
        w -= 0.5*dt*ft*(R - d)/inertia


# radius, density, E, nu of both materials; friction, restitution
SETS = {
    4: (0.0025, [(4000, 380e9, 0.23), (2700, 70e9, 0.33)], 0.092, 0.98),
    5: (1e-5, [(7850, 208e9, 0.30), (1400, 1e9, 0.40)], 0.3, 1.0),
    6: (0.1, [(2700, 70e9, 0.33), (1000, 2.5e9, 0.40)], 0.4, 0.5),
}
ANGLES = [5, 10, 15, 20, 25, 30, 35, 40, 50, 60, 70, 80, 85]
SLOPES = [0.0665, 0.3323, 0.6707, 1.009, 1.335, 1.662, 2.0, 2.35, 2.991, 3.341, 4.006, 4.997, 6.0,
          7.5, 10.0, 12.96, 20.0]


def cases(test):
    """Normal speed, tangential speed, spin."""
    if test == 4:
        for a in ANGLES:
            yield 3.9*math.cos(math.radians(a)), 3.9*math.sin(math.radians(a)), 0.0
    elif test == 5:
        for x in SLOPES:
            yield 5.0, x*0.3*5.0, 0.0
    else:
        for a in range(5, 90, 5):
            yield 0.2, 0.0, 2.0*math.tan(math.radians(a))


print("# Sets: tests 4 to 6 of Chung and Ooi, Granul. Matter 13 (2011) 643; values of an independent integration (oblique_impacts.py)")
print("test,material,law,normal_in_m_s,tangential_in_m_s,spin_in_1_s,normal_out,tangential_out,spin_out")
for test, (R, materials, mu, e) in SETS.items():
    for number, (rho, E, nu) in enumerate(materials, 1):
        for law in 1, 2, 3:
            for vn, vt, w in cases(test):
                out = impact(law, R, rho, E, nu, mu, e, vn, vt, w, {4: 3.9, 5: 5.0, 6: 0.2}[test])
                print("%d,%d,%d,%.10g,%.10g,%.10g,%.8g,%.8g,%.8g" %
                      (test, number, law, vn, vt, w, *out))
