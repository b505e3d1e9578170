/*---------------------------------------------------------------------------*\
    demWedge.C -- couples particles in a full circle to a fluid mesh that is a sector.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demWedge.H"
#include "demDict.H"
#include "mathematicalConstants.H"
#include "wedgePolyPatch.H"

namespace Foam
{
    using constant::mathematical::pi;

    // Plane sides of a swept wall. The middle of a side is nearer to the axis than
    // the circle by 3e-4 of its radius, a corner is farther by 6e-4.
    static const label sides = 72;

    // Tolerance over the size of the mesh: points closer than this are one point, or
    // on the axis
    static const scalar tolerance = 1e-6;

    // Gravity is along the axis if the cosine is less than 1 by this at most
    static const scalar maxTilt = 1e-6;


    static wordList wedges(const polyMesh& mesh)
    {
        DynamicList<word> names;
        for (const polyPatch& patch : mesh.boundaryMesh())
        {
            if (isA<wedgePolyPatch>(patch))
            {
                names.append(patch.name());
            }
        }
        return wordList(names);
    }
}


bool Foam::demWedge::is(const polyMesh& mesh)
{
    return wedges(mesh).size();
}


Foam::demWedge::demWedge(const polyMesh& mesh)
:
    mesh_(mesh)
{
    const wordList names(wedges(mesh));
    vector n[2];
    scalar off[2];

    if (names.size() != 2)
    {
        FatalErrorInFunction
            << "There are " << names.size() << " patches of type wedge, "
            << flatOutput(names) << ", but a sector lies between two; make them"
            << " two, one on each side of the middle plane" << exit(FatalError);
    }

    const point middle(mesh.bounds().midpoint());
    for (label k = 0; k < 2; ++k)
    {
        const polyPatch& patch = mesh.boundaryMesh()[names[k]];
        n[k] = refCast<const wedgePolyPatch>(patch).n();
        off[k] = gAverage(((patch.faceCentres() - middle) & n[k])());
    }

    // Normals point out of the sector
    angle_ = std::atan2(mag(n[0] ^ n[1]), -(n[0] & n[1]));
    axis_ = normalised(n[0] ^ n[1]);
    radialAxis_ = -(n[0] + n[1]);
    radialAxis_ = normalised(radialAxis_ - axis_*(axis_ & radialAxis_));
    azimuthalAxis_ = axis_ ^ radialAxis_;

    // On the line where both planes intersect, nearest to the middle of the mesh
    const scalar c = n[0] & n[1];
    origin_ =
        middle
      + (n[0]*(off[0] - c*off[1]) + n[1]*(off[1] - c*off[0]))/(1 - c*c);
}


void Foam::demWedge::check(const demDict& dict) const
{
    const vector& g = dict.gravity();

    if (mag(g & axis_) < (1 - maxTilt)*mag(g))
    {
        FatalErrorInFunction
            << "Gravity is " << g << " m/s2, but the mesh is a wedge about "
            << axis_ << " and its fluid is axisymmetric; let gravity point"
            << " along the axis, or mesh the whole circle" << exit(FatalError);
    }

    const dictionary streams(dict.scene().subOrEmptyDict("insert"));
    forAllConstIters(streams, iter)
    {
        if (iter().isDict() && iter().dict().found("patch"))
        {
            FatalIOErrorInFunction(iter().dict())
                << "insert/" << iter().keyword() << ": a patch of a wedge is a"
                << " sector, but particles are inserted over the full circle; give a"
                << " disc before it, with a velocity" << exit(FatalIOError);
        }
    }

    const dictionary& coupling = dict.coupling();
    if (coupling.subOrEmptyDict("record").getOrDefault("budget", false))
    {
        FatalIOErrorInFunction(coupling)
            << "coupling/record/budget is not available on a wedge, where the fluid"
            << " is a sector and the particles fill the full circle; take it out,"
            << " the log has the momentum along the axis" << exit(FatalIOError);
    }
    for (const word& name : coupling.getOrDefault("fields", wordList()))
    {
        if (name == "Theta" || name == "stress")
        {
            FatalIOErrorInFunction(coupling)
                << "fields: " << name << " is not available on a wedge; take alpha"
                << " and U, or averages in boxes of your own"
                << exit(FatalIOError);
        }
    }
}


Foam::scalar Foam::demWedge::fraction() const
{
    return std::sin(angle_)/(2*pi);
}


Foam::point Foam::demWedge::rotated(const point& x, const scalar angle) const
{
    const scalar r = radius(x);

    return x + r*((std::cos(angle) - 1)*radialAxis_ + std::sin(angle)*azimuthalAxis_);
}


void Foam::demWedge::rotateIn(const demView& view)
{
    const size_t step = view.stride/sizeof(double);
    const scalar chord = std::cos(0.5*angle_);

    position_.assign(step*view.n, 0);
    velocity_.assign(step*view.n, 0);
    radial_.setSize(view.n);
    distance_.setSize(view.n);
    damping_.setSize(view.n);
    damping_ = 1;

    forAll(radial_, i)
    {
        const double* x = dem_at(view.position, view.stride, i);
        const double* v = dem_at(view.velocity, view.stride, i);
        const vector d(vector(x[0], x[1], x[2]) - origin_);
        const vector u(v[0], v[1], v[2]);
        const vector t(across(d));
        const scalar r = mag(t);

        radial_[i] = r > 0 ? t/r : radialAxis_;
        distance_[i] = chord*r;

        const point inPlane(origin_ + (d - t) + distance_[i]*radialAxis_);
        const vector rotatedU
        (
            axis_*(axis_ & u) + radialAxis_*(radial_[i] & u)
          + azimuthalAxis_*((axis_ ^ radial_[i]) & u)
        );
        for (direction k = 0; k < 3; ++k)
        {
            position_[step*i + k] = inPlane[k];
            velocity_[step*i + k] = rotatedU[k];
        }
    }
}


void Foam::demWedge::setDamping(const UList<scalar>& weightedRadius)
{
    forAll(damping_, i)
    {
        damping_[i] = distance_[i] < weightedRadius[i] ? distance_[i]/weightedRadius[i] : 1;
    }
}


void Foam::demWedge::rotateOut(UList<vector>& values) const
{
    forAll(values, i)
    {
        const vector u(values[i]);

        values[i] =
            axis_*(axis_ & u)
          + damping_[i]
           *(radial_[i]*(radialAxis_ & u) + (axis_ ^ radial_[i])*(azimuthalAxis_ & u));
    }
}


void Foam::demWedge::toSector(UList<scalar>& values) const
{
    const scalar part = fraction();

    for (scalar& value : values)
    {
        value *= part;
    }
}


void Foam::demWedge::toSector(UList<vector>& values) const
{
    const scalar part = fraction();

    forAll(values, i)
    {
        const vector f(part*values[i]);

        values[i] =
            axis_*(axis_ & f)
          + damping_[i]
           *(radialAxis_*(radial_[i] & f) + azimuthalAxis_*((axis_ ^ radial_[i]) & f));
    }
}


// * * * * * * * * * * * * * * * * walls * * * * * * * * * * * * * * * * * * //

// A wall face is a line segment swept through the sector: its points project on the
// two ends of that segment in the middle plane
void Foam::demWedge::meridian
(
    const face& f,
    const pointField& points,
    DynamicList<point>& ends
) const
{
    const scalar minDistance = tolerance*mesh_.bounds().mag();

    ends.clear();
    for (const label pointi : f)
    {
        const vector d(points[pointi] - origin_);
        const vector t(across(d));
        const scalar r = mag(t) > minDistance ? mag(t) : 0;
        const point here(origin_ + (d - t) + r*radialAxis_);
        bool known = false;

        for (const point& end : ends)
        {
            known = known || mag(end - here) < minDistance;
        }
        if (!known)
        {
            ends.append(here);
        }
    }
}


Foam::tmp<Foam::pointField> Foam::demWedge::sweep
(
    const polyPatch& patch,
    const pointField& points
) const
{
    const scalar side = 2*pi/sides;
    const scalar stretch = std::sqrt(side/std::sin(side));
    const scalar minDistance = tolerance*mesh_.bounds().mag();
    DynamicList<point> corners(6*sides*patch.size());
    DynamicList<point> ends;

    for (const face& f : patch)
    {
        meridian(f, points, ends);
        if (ends.size() != 2)
        {
            FatalErrorInFunction
                << "Patch " << patch.name() << " is a wall, but a face of it"
                << " is not one that goes through the wedge from side to side;"
                << " make the mesh one cell thick" << exit(FatalError);
        }
        for (label k = 0; k < sides; ++k)
        {
            point p[4];
            for (label e = 0; e < 4; ++e)
            {
                const point& x = ends[e % 2];
                p[e] = rotated
                (
                    x + (stretch - 1)*radius(x)*radialAxis_,
                    side*((k + e/2) % sides)
                );
            }
            if (radius(ends[0]) > minDistance)
            {
                corners.append(p[0]);
                corners.append(p[1]);
                corners.append(p[2]);
            }
            if (radius(ends[1]) > minDistance)
            {
                corners.append(p[1]);
                corners.append(p[3]);
                corners.append(p[2]);
            }
        }
    }

    tmp<pointField> tpoints(new pointField());
    tpoints.ref().transfer(corners);
    return tpoints;
}
