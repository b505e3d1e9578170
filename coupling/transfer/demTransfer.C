/*---------------------------------------------------------------------------*\
    demTransfer.C -- locate particles, deposit their values on the mesh, sample
    fields at them.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demTransfer.H"
#include "demCheck.H"
#include "demSphereKernel.H"
#include "demGaussianKernel.H"
#include "demSlidingInterface.H"

namespace Foam
{
    // Mean variance of the linear weights over the square of the distance between
    // cell centres, beyond that of a cell value as a mean over the cell. In one
    // direction the points, edges and faces of a box are half a cell from its centre
    // and have 3/4 of the weight on the mean, the centre 1/4. That gives 3/8, less
    // 1/12 for the particle's position in the cell and 1/12 for the size of the cell.
    static const scalar linearVariance = 5.0/24.0;
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
            << "coupling/" << name << " is a setting of the smoothing, which kernel "
            << coupling.get<word>("kernel") << " does not have; take it out,"
            << " or use kernel diffusion" << exit(FatalIOError);
    }
}


void Foam::demTransfer::read(const dictionary& coupling)
{
    // in the order of enum base
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
            << (width_ < 0 ? " is negative; give the"
              : " is no width for kernel gaussian; give its")
            << " width in particle diameters, 3 for example"
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
    routing_.clear();
    footprint_.clear();
    if (demSlidingInterface::any(mesh_))
    {
        interface_.reset(new demSlidingInterface(mesh_));
    }
    locator_.reset(new demLocator(mesh_, outlets_, interface_.get()));
    routing_.reset(new demParticleRouting(mesh_, locator_()));
    weights_.clear();
    if (base_ == LINEAR || base_ == CENTRE)
    {
        weights_.reset(new demLinearWeights(mesh_, interface_.get()));
        if (evens())
        {
            weights_().setEven();
        }
    }
    smoother_.reset(new demSmoother(mesh_, wedge_.get(), interface_.get()));
    limiter_.reset(new demOverpackingLimiter(mesh_, interface_.get()));
    setWidths();
}


void Foam::demTransfer::setWidths()
{
    if (smooths_)
    {
        smoother_().setWidth
        (
            width_*diameter_,
            base_ == LINEAR ? linearVariance : 0,
            base_ == DIVIDED ? demSphereKernel::variance*sqr(0.5*diameter_) : 0
        );
    }
    footprint_.clear();
    kernel_.clear();
    if (base_ == DIVIDED)
    {
        kernel_.reset(new demSphereKernel(mesh_));
    }
    else if (base_ == GAUSSIAN && diameter_ > 0)
    {
        kernel_.reset(new demGaussianKernel(mesh_, width_*diameter_));
    }
    if (kernel_.valid() && wedge_.valid())
    {
        kernel_.reset(new demRingKernel(wedge_(), kernel_.ptr()));
    }
    if (kernel_.valid())
    {
        footprint_.reset(new demFootprint(mesh_, locator_(), kernel_()));
    }
}


Foam::demTransfer::demTransfer
(
    const fvMesh& mesh,
    const dictionary& coupling,
    const labelUList& outlets
)
:
    mesh_(mesh),
    outlets_(outlets),
    base_(LINEAR),
    width_(0),
    smooths_(false),
    minVoidFraction_(0),
    diameter_(0)
{
    read(coupling);
    demSlidingInterface::check(mesh);
    if (demWedge::is(mesh))
    {
        wedge_.reset(new demWedge(mesh));
    }
    build();
}


void Foam::demTransfer::setDiameter(const scalar d)
{
    const scalar limit = mesh_.bounds().mag();

    if (width_*d > limit)
    {
        FatalErrorInFunction
            << "coupling/width is " << width_ << " diameters of " << d
            << " m, together more than the length of the mesh (" << limit
            << " m); give a smaller width or diameter" << exit(FatalError);
    }
    if (d != diameter_)
    {
        diameter_ = d;
        setWidths();
    }
}


// From the smallest cell of the mesh; no search for the cell of each particle
Foam::scalar Foam::demTransfer::surfaceLayer() const
{
    return
        width_ > 0 ? width_*diameter_
      : base_ == LINEAR ? 0.5*std::cbrt(gAverage(mesh_.V().field()))
      : base_ == DIVIDED ? 0.5*diameter_
      : 0;
}


Foam::scalar Foam::demTransfer::length() const
{
    return max(std::cbrt(gMin(mesh_.V().field())), 0.5*width_*diameter_);
}


Foam::demParticleRouting::lostParticles Foam::demTransfer::locate
(
    const demView& view,
    double* rankCell,
    demParticleRouting::boundaryCheck* boundary
)
{
    if (mesh_.changing())
    {
        if (wedge_.valid())
        {
            FatalErrorInFunction
                << "The mesh is a wedge and moves, but the swept walls of the"
                << " particles cannot move with it; mesh the whole circle, or set"
                << " dynamicFvMesh staticFvMesh in constant/dynamicMeshDict"
                << exit(FatalError);
        }
        build();
    }
    limiter_().clear();
    if (wedge_.valid())
    {
        wedge_().rotateIn(view);
    }

    const demParticleRouting::lostParticles outside
    (
        routing_().locate(inMeshFrame(view), rankCell, boundary)
    );
    if (outside.count)
    {
        return outside;
    }
    if (base_ == CENTRE)
    {
        routing_().toCentres();
    }
    updateFootprints(view);
    updateDamping();
    return outside;
}


void Foam::demTransfer::updateFootprints(const demView& view)
{
    if (footprint_.valid())
    {
        scalarList radius(routing_().nParticles());
        forAll(radius, i)
        {
            radius[i] = *dem_at(view.radius, view.stride, i);
        }
        routing_().toMesh(radius);
        footprint_().update(routing_().locations(), radius);
    }
}


void Foam::demTransfer::updateDamping()
{
    if (wedge_.valid())
    {
        scalarField r(mesh_.nCells());
        forAll(r, celli)
        {
            r[celli] = wedge_().radius(mesh_.cellCentres()[celli]);
        }
        wedge_().setDamping(gather<scalar>(r)());
    }
}


template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::demTransfer::gather(const UList<Type>& cells) const
{
    tmp<Field<Type>> tvalues(new Field<Type>(routing_().locations().size()));
    if (footprint_.valid())
    {
        footprint_().collect(cells, tvalues.ref());
    }
    else if (weights_.valid())
    {
        weights_().collect(routing_().locations(), cells, tvalues.ref());
    }
    routing_().toParticles(tvalues.ref());
    return tvalues;
}


template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::demTransfer::sample(const UList<Type>& cells) const
{
    Field<Type> smooth(cells);
    limiter_().collect(smooth);
    smoother_().smooth(smooth);
    if (evens())
    {
        weights_().evenAdjoint(smooth);
    }

    tmp<Field<Type>> tvalues(gather<Type>(smooth));
    if (wedge_.valid())
    {
        wedge_().rotateOut(tvalues.ref());
    }
    return tvalues;
}


template<class Type>
void Foam::demTransfer::depositUnlimited
(
    const UList<Type>& perParticle,
    Field<Type>& density
) const
{
    List<Type> values(perParticle);
    if (wedge_.valid())
    {
        wedge_().toSector(values);
    }
    routing_().toMesh(values);

    density.setSize(mesh_.nCells());
    density = Zero;
    if (footprint_.valid())
    {
        footprint_().spread(values, density);
    }
    else if (weights_.valid())
    {
        weights_().spread(routing_().locations(), values, density);
        if (evens())
        {
            weights_().even(density);
        }
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
    depositUnlimited(perParticle, density);
    limiter_().spread(density);
}


void Foam::demTransfer::depositVolume
(
    const UList<scalar>& volumes,
    volScalarField::Internal& solid
)
{
    depositUnlimited(volumes, solid.field());
    limiter_().limitSolid(solid.field(), 1 - minVoidFraction_);
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
