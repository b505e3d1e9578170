/*---------------------------------------------------------------------------*\
    demTransfer.C -- locate, sample, deposit.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demTransfer.H"
#include "demCheck.H"
#include "demBall.H"
#include "demBell.H"

namespace Foam
{
    // Mean widening of a point by the linear weights, over the square of the
    // distance between cells, that a value's being the mean of its cell does not
    // explain: the corners, edges and faces of a box lie a half off in the square,
    // its centre 0, and a point inside has a quarter of the centre on the mean:
    // 3/8, less 1/12 for where in the cell it is and 1/12 for the cell's own size
    static const scalar linearWidens = 5.0/24.0;
}


void Foam::demTransfer::check
(
    const dictionary& coupling,
    const char* name,
    const bool used
) const
{
    if (!used && coupling.found(name))
    {
        FatalIOErrorInFunction(coupling)
            << "coupling/" << name << " is of the smoothing, but kernel "
            << coupling.get<word>("kernel") << " does not need it; take it out,"
            << " or use kernel diffusion" << exit(FatalIOError);
    }
}


void Foam::demTransfer::read(const dictionary& coupling)
{
    // in the order of the enumeration
    const wordList bases({"linear", "particleCentre", "divided", "gaussian"});
    const wordList kernels({"diffusion", bases[0], bases[1], bases[2], bases[3]});
    const word kernel(coupling.getOrDefault<word>("kernel", "diffusion"));
    const word base(coupling.getOrDefault<word>("base", "linear"));

    if (!kernels.found(kernel))
    {
        demUnknown(coupling, "coupling", "kernel", kernel, kernels);
    }
    if (!bases.found(base) || base == "gaussian")
    {
        demUnknown(coupling, "coupling", "base", base, SubList<word>(bases, 3));
    }

    smooths_ = kernel == "diffusion";
    base_ = static_cast<enum base>(bases.find(smooths_ ? base : kernel));
    width_ = coupling.getOrDefault<scalar>("width", 3);
    minVoidFraction_ = coupling.getOrDefault<scalar>("minVoidFraction", 0.2);

    check(coupling, "base", smooths_);
    check(coupling, "width", smooths_ || base_ == GAUSSIAN);
    check(coupling, "diameter", smooths_ || base_ == GAUSSIAN);

    if (width_ < 0 || (width_ == 0 && base_ == GAUSSIAN))
    {
        FatalIOErrorInFunction(coupling)
            << "coupling/width " << width_
            << (width_ < 0 ? " is negative; give the" : " gives a Gaussian no size; give its")
            << " length in particle diameters, 3 for example"
            << (width_ < 0 ? ", 0 for no smoothing" : "") << exit(FatalIOError);
    }
    if (coupling.getOrDefault<scalar>("diameter", 1) <= 0)
    {
        FatalIOErrorInFunction(coupling)
            << "coupling/diameter is " << coupling.get<scalar>("diameter")
            << " m; it must be positive" << exit(FatalIOError);
    }
    if (minVoidFraction_ <= 0 || minVoidFraction_ >= 1)
    {
        FatalIOErrorInFunction(coupling)
            << "coupling/minVoidFraction " << minVoidFraction_ << " is out of"
            << " range; give a number above 0 and below 1, 0.2 for example" << exit(FatalIOError);
    }
    if (!smooths_ && base_ != GAUSSIAN)
    {
        width_ = 0;
    }
}


void Foam::demTransfer::build()
{
    route_.clear();
    footprint_.clear();
    locator_.reset(new demLocator(mesh_));
    route_.reset(new demRoute(mesh_, locator_()));
    weights_.clear();
    if (base_ == LINEAR || base_ == CENTRE)
    {
        weights_.reset(new demWeights(mesh_));
    }
    smoother_.reset(new demSmoother(mesh_, wedge_.get()));
    relief_.reset(new demRelief(mesh_));
    size();
}


void Foam::demTransfer::size()
{
    if (smooths_)
    {
        smoother_().setWidth
        (
            width_*diameter_,
            base_ == LINEAR ? linearWidens : 0,
            base_ == DIVIDED ? demBall::variance*sqr(0.5*diameter_) : 0
        );
    }
    footprint_.clear();
    shape_.clear();
    if (base_ == DIVIDED)
    {
        shape_.reset(new demBall(mesh_));
    }
    else if (base_ == GAUSSIAN && diameter_ > 0)
    {
        shape_.reset(new demBell(mesh_, width_*diameter_));
    }
    if (shape_.valid() && wedge_.valid())
    {
        shape_.reset(new demRing(wedge_(), shape_.ptr()));
    }
    if (shape_.valid())
    {
        footprint_.reset(new demFootprint(mesh_, locator_(), shape_()));
    }
}


Foam::demTransfer::demTransfer(const fvMesh& mesh, const dictionary& coupling)
:
    mesh_(mesh),
    base_(LINEAR),
    width_(0),
    smooths_(false),
    minVoidFraction_(0),
    diameter_(0)
{
    read(coupling);
    if (demWedge::is(mesh))
    {
        wedge_.reset(new demWedge(mesh));
    }
    build();
}


void Foam::demTransfer::setDiameter(const scalar d)
{
    const scalar most = mesh_.bounds().mag();

    if (width_*d > most)
    {
        FatalErrorInFunction
            << "coupling/width is " << width_ << " diameters of " << d
            << " m, together more than the mesh is long (" << most
            << " m); give a smaller width or diameter" << exit(FatalError);
    }
    if (d != diameter_)
    {
        diameter_ = d;
        size();
    }
}


// The smallest cell speaks for all: no cell is asked for per particle
Foam::scalar Foam::demTransfer::length() const
{
    return max(std::cbrt(gMin(mesh_.V().field())), 0.5*width_*diameter_);
}


Foam::demRoute::stray Foam::demTransfer::locate
(
    const demView& view,
    double* place,
    demRoute::exits* out
)
{
    if (mesh_.changing())
    {
        if (wedge_.valid())
        {
            FatalErrorInFunction
                << "The mesh is a wedge and moves, but walls all around do not"
                << " move with it; mesh the whole circle, or take dynamicFvMesh"
                << " staticFvMesh in constant/dynamicMeshDict"
                << exit(FatalError);
        }
        build();
    }
    relief_().clear();
    if (wedge_.valid())
    {
        wedge_().fold(view);
    }

    const demRoute::stray outside(route_().locate(seen(view), place, out));
    if (outside.count)
    {
        return outside;
    }
    if (base_ == CENTRE)
    {
        route_().toCentres();
    }
    cover(view);
    fade();
    return outside;
}


void Foam::demTransfer::cover(const demView& view)
{
    if (footprint_.valid())
    {
        scalarList radius(route_().nParticles());
        forAll(radius, i)
        {
            radius[i] = *dem_at(view.radius, view.stride, i);
        }
        route_().toSpots(radius);
        footprint_().update(route_().spots(), radius);
    }
}


void Foam::demTransfer::fade()
{
    if (wedge_.valid())
    {
        scalarField r(mesh_.nCells());
        forAll(r, celli)
        {
            r[celli] = wedge_().radius(mesh_.cellCentres()[celli]);
        }
        wedge_().setFade(gather<scalar>(r)());
    }
}


template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::demTransfer::gather(const UList<Type>& cells) const
{
    tmp<Field<Type>> tvalues(new Field<Type>(route_().spots().size()));
    if (footprint_.valid())
    {
        footprint_().collect(cells, tvalues.ref());
    }
    else if (weights_.valid())
    {
        weights_().collect(route_().spots(), cells, tvalues.ref());
    }
    route_().toParticles(tvalues.ref());
    return tvalues;
}


template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::demTransfer::sample(const UList<Type>& cells) const
{
    Field<Type> smooth(cells);
    relief_().collect(smooth);
    smoother_().smooth(smooth);

    tmp<Field<Type>> tvalues(gather<Type>(smooth));
    if (wedge_.valid())
    {
        wedge_().turn(tvalues.ref());
    }
    return tvalues;
}


template<class Type>
void Foam::demTransfer::put
(
    const UList<Type>& perParticle,
    Field<Type>& density
) const
{
    List<Type> values(perParticle);
    if (wedge_.valid())
    {
        wedge_().back(values);
    }
    route_().toSpots(values);

    density.setSize(mesh_.nCells());
    density = Zero;
    if (footprint_.valid())
    {
        footprint_().spread(values, density);
    }
    else if (weights_.valid())
    {
        weights_().spread(route_().spots(), values, density);
    }
    density /= mesh_.V().field();
    smoother_().smooth(density);
}


template<class Type>
void Foam::demTransfer::deposit
(
    const UList<Type>& perParticle,
    Field<Type>& density
) const
{
    put(perParticle, density);
    relief_().spread(density);
}


void Foam::demTransfer::depositVolume
(
    const UList<scalar>& volumes,
    volScalarField::Internal& solid
)
{
    put(volumes, solid.field());
    relief_().relieve(solid.field(), 1 - minVoidFraction_);
}


#define INSTANTIATE(Type, VolField)                                            \
                                                                               \
template Foam::tmp<Foam::Field<Foam::Type>>                                    \
Foam::demTransfer::sample(const UList<Type>&) const;                           \
                                                                               \
template void Foam::demTransfer::deposit                                       \
(const UList<Type>&, Field<Type>&) const;                                      \
                                                                               \
Foam::tmp<Foam::Field<Foam::Type>>                                             \
Foam::demTransfer::sample(const VolField& field) const                         \
{                                                                              \
    return sample<Type>(field.primitiveField());                               \
}                                                                              \
                                                                               \
void Foam::demTransfer::deposit                                                \
(const UList<Type>& perParticle, VolField& density) const                      \
{                                                                              \
    deposit<Type>(perParticle, density.primitiveFieldRef());                   \
    density.correctBoundaryConditions();                                       \
}                                                                              \
                                                                               \
void Foam::demTransfer::deposit                                                \
(const UList<Type>& perParticle, VolField::Internal& density) const            \
{                                                                              \
    deposit<Type>(perParticle, density.field());                               \
}

INSTANTIATE(scalar, volScalarField)
INSTANTIATE(vector, volVectorField)

#undef INSTANTIATE


// ************************************************************************* //
