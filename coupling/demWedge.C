/*---------------------------------------------------------------------------*\
    demWedge.C -- particles all around an axis, fluid in a sector.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demWedge.H"
#include "demDict.H"
#include "mathematicalConstants.H"
#include "wedgePolyPatch.H"

namespace Foam
{
    using constant::mathematical::pi;

    // Plane sides of a swept wall: its flats are nearer to the axis than the
    // circle by 3e-4 of its radius, its corners farther by 6e-4
    static const label sides = 72;

    // Of the mesh's size: points that are one, and on the axis
    static const scalar same = 1e-6;

    // Cosine less than 1 by this: gravity is along the axis
    static const scalar along = 1e-6;


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


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

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
    out_ = -(n[0] + n[1]);
    out_ = normalised(out_ - axis_*(axis_ & out_));
    round_ = axis_ ^ out_;

    // Where both planes meet, next to the middle of the mesh
    const scalar c = n[0] & n[1];
    origin_ =
        middle
      + (n[0]*(off[0] - c*off[1]) + n[1]*(off[1] - c*off[0]))/(1 - c*c);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::demWedge::check(const demDict& dict) const
{
    const vector& g = dict.gravity();

    if (mag(g & axis_) < (1 - along)*mag(g))
    {
        FatalErrorInFunction
            << "Gravity is " << g << " m/s2, but the mesh is a wedge about "
            << axis_ << " and its fluid the same all around; let gravity point"
            << " along the axis, or mesh the whole circle" << exit(FatalError);
    }

    const dictionary streams(dict.scene().subOrEmptyDict("insert"));
    forAllConstIters(streams, iter)
    {
        if (iter().isDict() && iter().dict().found("patch"))
        {
            FatalIOErrorInFunction(iter().dict())
                << "insert/" << iter().keyword() << ": a patch of a wedge is a"
                << " sector, and particles come in all around; give a disc"
                << " before it, with a velocity" << exit(FatalIOError);
        }
    }

    const dictionary& coupling = dict.coupling();
    if (coupling.subOrEmptyDict("record").getOrDefault("budget", false))
    {
        FatalIOErrorInFunction(coupling)
            << "coupling/record/budget has no books of a wedge, where the fluid"
            << " is a sector and the particles are all around; take it out, the"
            << " log tells the momentum along the axis" << exit(FatalIOError);
    }
    for (const word& name : coupling.getOrDefault("fields", wordList()))
    {
        if (name == "Theta" || name == "stress")
        {
            FatalIOErrorInFunction(coupling)
                << "fields: " << name << " is not there on a wedge; take alpha"
                << " and U, or averages in boxes of your own"
                << exit(FatalIOError);
        }
    }
}


Foam::scalar Foam::demWedge::share() const
{
    return std::sin(angle_)/(2*pi);
}


Foam::point Foam::demWedge::turned(const point& x, const scalar angle) const
{
    const scalar r = radius(x);

    return x + r*((std::cos(angle) - 1)*out_ + std::sin(angle)*round_);
}


void Foam::demWedge::fold(const demView& view)
{
    const size_t step = view.stride/sizeof(double);
    const scalar chord = std::cos(0.5*angle_);

    place_.assign(step*view.n, 0);
    velocity_.assign(step*view.n, 0);
    radial_.setSize(view.n);
    distance_.setSize(view.n);
    fade_.setSize(view.n);
    fade_ = 1;

    forAll(radial_, i)
    {
        const double* x = dem_at(view.position, view.stride, i);
        const double* v = dem_at(view.velocity, view.stride, i);
        const vector d(vector(x[0], x[1], x[2]) - origin_);
        const vector u(v[0], v[1], v[2]);
        const vector t(across(d));
        const scalar r = mag(t);

        radial_[i] = r > 0 ? t/r : out_;
        distance_[i] = chord*r;

        const point seen(origin_ + (d - t) + distance_[i]*out_);
        const vector turned
        (
            axis_*(axis_ & u) + out_*(radial_[i] & u)
          + round_*((axis_ ^ radial_[i]) & u)
        );
        for (direction k = 0; k < 3; ++k)
        {
            place_[step*i + k] = seen[k];
            velocity_[step*i + k] = turned[k];
        }
    }
}


void Foam::demWedge::setFade(const UList<scalar>& weighed)
{
    forAll(fade_, i)
    {
        fade_[i] = distance_[i] < weighed[i] ? distance_[i]/weighed[i] : 1;
    }
}


void Foam::demWedge::turn(UList<vector>& values) const
{
    forAll(values, i)
    {
        const vector u(values[i]);

        values[i] =
            axis_*(axis_ & u)
          + fade_[i]
           *(radial_[i]*(out_ & u) + (axis_ ^ radial_[i])*(round_ & u));
    }
}


void Foam::demWedge::back(UList<scalar>& values) const
{
    const scalar part = share();

    for (scalar& value : values)
    {
        value *= part;
    }
}


void Foam::demWedge::back(UList<vector>& values) const
{
    const scalar part = share();

    forAll(values, i)
    {
        const vector f(part*values[i]);

        values[i] =
            axis_*(axis_ & f)
          + fade_[i]
           *(out_*(radial_[i] & f) + round_*((axis_ ^ radial_[i]) & f));
    }
}


// * * * * * * * * * * * * * * * * walls * * * * * * * * * * * * * * * * * * //

// A wall's face is a piece of a line, swept through the sector: its points lie
// in two places of the middle plane
void Foam::demWedge::meridian
(
    const face& f,
    const pointField& points,
    DynamicList<point>& ends
) const
{
    const scalar near = same*mesh_.bounds().mag();

    ends.clear();
    for (const label pointi : f)
    {
        const vector d(points[pointi] - origin_);
        const vector t(across(d));
        const scalar r = mag(t) > near ? mag(t) : 0;
        const point here(origin_ + (d - t) + r*out_);
        bool known = false;

        for (const point& end : ends)
        {
            known = known || mag(end - here) < near;
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
    const scalar near = same*mesh_.bounds().mag();
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
                p[e] = turned
                (
                    x + (stretch - 1)*radius(x)*out_,
                    side*((k + e/2) % sides)
                );
            }
            if (radius(ends[0]) > near)
            {
                corners.append(p[0]);
                corners.append(p[1]);
                corners.append(p[2]);
            }
            if (radius(ends[1]) > near)
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


// * * * * * * * * * * * * * * * * ring  * * * * * * * * * * * * * * * * * * //

// The particle as it is seen from the k-th sector on either side; where they
// meet opposite, as much of it as the circle has room for
Foam::scalar Foam::demRing::share
(
    const label celli,
    const point& x,
    const scalar radius
) const
{
    const scalar angle = wedge_.angle();
    const scalar r = wedge_.radius(x);
    const scalar far = reach(radius);
    scalar sum = one_().share(celli, x, radius);

    for (label k = 1; (k - 0.5)*angle < pi; ++k)
    {
        const scalar between = (k - 0.5)*angle;
        const scalar room = min(scalar(1), (pi - between)/angle);

        if (r*std::sin(min(between, 0.5*pi)) >= far)
        {
            break;
        }
        sum += 2*room*one_().share(celli, wedge_.turned(x, k*angle), radius);
    }
    return sum;
}

// ************************************************************************* //
