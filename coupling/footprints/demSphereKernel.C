/*---------------------------------------------------------------------------*\
    demSphereKernel.C -- exact volume of the intersection of a sphere and a
    polyhedral cell.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demSphereKernel.H"
#include "volFields.H"

namespace Foam
{
    // Height of a face's points above its plane, over its size, up to which the face
    // counts as plane. The error is that fraction of a sphere at most and is
    // removed when the weights are normalised.
    static const scalar planeTolerance = 1e-9;

    defineTypeNameAndDebug(demSphereKernel, 0);
    addToRunTimeSelectionTable(demKernel, demSphereKernel, parts);
}


Foam::demSphereKernel::demSphereKernel(const parts& p)
:
    demFootprintKernel(p),
    plane_(mesh_.nFaces(), true),
    faceMean_(mesh_.nFaces(), Zero)
{
    forAll(plane_, facei)
    {
        const face& f = mesh_.faces()[facei];
        const vector& S = mesh_.faceAreas()[facei];
        for (const label pointi : f)
        {
            faceMean_[facei] += mesh_.points()[pointi]/f.size();
        }
        for (const label pointi : f)
        {
            const vector d(mesh_.points()[pointi] - faceMean_[facei]);
            plane_[facei] = plane_[facei] && mag(d & S) <= planeTolerance*mag(d)*mag(S);
        }
    }
}


Foam::scalar Foam::demSphereKernel::edge
(
    const vector& a,
    const vector& b,
    const vector& normal,
    const scalar h,
    const scalar R
)
{
    const vector e(b - a);
    const scalar length = mag(e);
    if (length <= VSMALL)
    {
        return 0;
    }
    const scalar side = ((a ^ b) & normal)/length;
    const scalar r = mag(side);
    const scalar t1 = (a & e)/length;
    const scalar t2 = (b & e)/length;
    const scalar c = max(scalar(0), R*R - h*h);
    const scalar perAngle = h < R ? h*c/6 + R*R*h/3 : R*R*R/3;

    // integral outside the circle
    const auto beyond = [&](const scalar from, const scalar to)
    {
        const scalar phi = std::atan2(to, r) - std::atan2(from, r);
        const auto psi = [&](const scalar t)
        {
            return std::atan2(h*t, r*std::sqrt(h*h + r*r + t*t));
        };
        return perAngle*phi - R*R*R/3*(psi(to) - psi(from));
    };

    scalar sum;
    if (r*r < c)
    {
        const scalar half = std::sqrt(c - r*r);
        const scalar in1 = max(-half, min(half, t1));
        const scalar in2 = max(-half, min(half, t2));
        sum = h*r*(in2 - in1)/6;
        if (t1 < in1) sum += beyond(t1, in1);
        if (t2 > in2) sum += beyond(in2, t2);
        // an edge that lies wholly beyond one end of the chord
        if (t2 < in2) sum -= beyond(t2, in2);
        if (t1 > in1) sum -= beyond(in1, t1);
    }
    else
    {
        sum = beyond(t1, t2);
    }
    return side < 0 ? -sum : sum;
}


Foam::scalar Foam::demSphereKernel::cone
(
    const label facei,
    const point& x,
    const scalar R
) const
{
    const pointField& points = mesh_.points();
    const face& f = mesh_.faces()[facei];

    // one plane polygon, or the triangles of the mean point and the edges
    if (plane_[facei])
    {
        const vector n(normalised(mesh_.faceAreas()[facei]));
        const scalar h = (faceMean_[facei] - x) & n;
        const point foot(x + h*n);
        scalar sum = 0;
        forAll(f, k)
        {
            sum += edge(points[f[k]] - foot, points[f.nextLabel(k)] - foot, n, mag(h), R);
        }
        return h < 0 ? -sum : sum;
    }

    scalar total = 0;
    forAll(f, k)
    {
        const point corner[3] = {faceMean_[facei], points[f[k]], points[f.nextLabel(k)]};
        const vector S((corner[1] - corner[0]) ^ (corner[2] - corner[0]));
        if (mag(S) <= VSMALL) continue;

        const vector n(S/mag(S));
        const scalar h = (corner[0] - x) & n;
        const point foot(x + h*n);
        scalar sum = 0;
        for (label i = 0; i < 3; ++i)
        {
            sum += edge(corner[i] - foot, corner[(i + 1) % 3] - foot, n, mag(h), R);
        }
        total += h < 0 ? -sum : sum;
    }
    return total;
}


Foam::scalar Foam::demSphereKernel::integral
(
    const label celli,
    const point& x,
    const scalar radius
) const
{
    bool within = true;
    for (const label pointi : mesh_.cellPoints()[celli])
    {
        within = within && magSqr(mesh_.points()[pointi] - x) <= sqr(radius);
    }
    if (within)
    {
        return mesh_.V()[celli];
    }

    scalar sum = 0;
    for (const label facei : mesh_.cells()[celli])
    {
        const scalar volume = cone(facei, x, radius);
        sum += mesh_.faceOwner()[facei] == celli ? volume : -volume;
    }
    return max(sum, scalar(0));
}
