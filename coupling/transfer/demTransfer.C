/*---------------------------------------------------------------------------*\
    demTransfer.C -- locates particles, deposits their values on the mesh, samples
    fields at them.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demTransfer.H"
#include "demCheck.H"
#include "demSlidingInterface.H"
#include <cstring>

void Foam::demTransfer::read()
{
    width_ = kernel_().uses("width") ? coupling_.getOrDefault<scalar>("width", 3) : 0;
    lawWidth_ = kernel_().uses("lawWidth") ? coupling_.getOrDefault<scalar>("lawWidth", 0) : 0;
    minVoidFraction_ = coupling_.getOrDefault<scalar>("minVoidFraction", 0.2);

    for (const word entry : {"base", "width", "lawWidth", "diameter"})
    {
        if (!kernel_().uses(entry) && coupling_.found(entry))
        {
            FatalIOErrorInFunction(coupling_)
                << "coupling/" << entry << " is a setting of the smoothing, which kernel "
                << kernel_().type() << " does not have; take it out, or use kernel diffusion"
                << exit(FatalIOError);
        }
    }
    const scalar diameter = coupling_.getOrDefault<scalar>("diameter", 1);
    const struct { const char* entry; scalar value; bool good; std::string cure; } numbers[] =
    {
        {"width", width_, width_ >= 0, "it in particle diameters, 3 for example, 0 for none"},
        {
            "lawWidth", lawWidth_, lawWidth_ >= 0 && lawWidth_ <= width_,
            "a number from 0, for none, to the width, " + Foam::name(width_)
        },
        {"diameter", diameter, diameter > 0, "a diameter above 0 m"},
        {
            "minVoidFraction", minVoidFraction_, minVoidFraction_ > 0 && minVoidFraction_ < 1,
            "a number above 0 and below 1, 0.2 for example"
        }
    };
    for (const auto& number : numbers)
    {
        if (!number.good)
        {
            FatalIOErrorInFunction(coupling_)
                << "coupling/" << number.entry << " is " << number.value << "; give "
                << number.cure.c_str() << exit(FatalIOError);
        }
    }
    if (lawWidth_ > 0 && (mesh_.nGeometricD() != 3 || wedge_.valid()))
    {
        FatalIOErrorInFunction(coupling_)
            << "coupling/lawWidth is for three-dimensional meshes, and this one is a wedge or"
            << " two-dimensional; take it out" << exit(FatalIOError);
    }
}


void Foam::demTransfer::setWidths()
{
    forget();
    shortWaves_.clear();
    kernel_().setWidth(diameter_, width_*diameter_);
    if (lawWidth_ > 0)
    {
        kernel_().setLawWidth(lawWidth_*diameter_);
    }
}


void Foam::demTransfer::build()
{
    routing_.clear();
    kernel_.clear();
    if (demSlidingInterface::any(mesh_))
    {
        interface_.reset(new demSlidingInterface(mesh_));
    }
    locator_.reset(new demLocator(mesh_, outlets_, interface_.get()));
    routing_.reset(new demParticleRouting(mesh_, locator_()));
    kernel_ = demKernel::New
    (
        {mesh_, coupling_, locator_(), wedge_.get(), interface_.get()}, "kernel", "diffusion"
    );
    limiter_.reset(new demOverpackingLimiter(mesh_, interface_.get()));
    setWidths();
}


Foam::demTransfer::demTransfer
(
    const fvMesh& mesh,
    const dictionary& coupling,
    const labelUList& outlets
)
:
    mesh_(mesh),
    coupling_(coupling),
    outlets_(outlets),
    width_(0),
    lawWidth_(0),
    minVoidFraction_(0),
    diameter_(0),
    keepsOwnWeights_(false),
    oldest_(0)
{
    demSlidingInterface::check(mesh);
    if (demWedge::is(mesh))
    {
        wedge_.reset(new demWedge(mesh));
    }
    build();
    read();
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
    const scalar width = lawWidth_ > 0 ? lawWidth_ : width_;
    return width > 0 ? width*diameter_ : kernel_().surfaceLayer(diameter_);
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
    forget();
    limiter_().clear();
    locator_().setPeriods(vector(view.period[0], view.period[1], view.period[2]));
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
    kernel_().update(view, routing_());
    if (keepsOwnWeights_)
    {
        ownWeights_ = findOwnWeights();
        if (lawWidth_ > 0)
        {
            ownLawWeights_.setSize(routing_().locations().size());
            kernel_().ownLawWeights(routing_().locations(), ownLawWeights_);
            routing_().toParticles(ownLawWeights_);
        }
    }
    updateDamping();
    return outside;
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
Foam::tmp<Foam::Field<Type>> Foam::demTransfer::gather(UList<Type>& cells) const
{
    tmp<Field<Type>> tvalues(new Field<Type>(routing_().locations().size()));
    kernel_().collect(routing_().locations(), cells, tvalues.ref());
    routing_().toParticles(tvalues.ref());
    return tvalues;
}


template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::demTransfer::sample(const UList<Type>& cells) const
{
    Field<Type> smooth(cells);
    limiter_().collect(smooth);
    kernel_().smooth(smooth);

    tmp<Field<Type>> tvalues(gather<Type>(smooth));
    if (wedge_.valid())
    {
        wedge_().rotateOut(tvalues.ref());
    }
    return tvalues;
}


void Foam::demTransfer::forget()
{
    for (sampled& s : recent_)
    {
        s.known = false;
    }
}


Foam::tmp<Foam::scalarField> Foam::demTransfer::sample(const volScalarField& field) const
{
    return sample<scalar>(field.primitiveField());
}


// A solver corrects the particles with fields that they receive again in the next step
Foam::tmp<Foam::vectorField> Foam::demTransfer::sample(const volVectorField& field) const
{
    const vectorField& cells = field.primitiveField();

    for (const sampled& s : recent_)
    {
        const bool same =
            s.known
         && std::memcmp(s.cells.cdata(), cells.cdata(), cells.size()*sizeof(vector)) == 0;

        if (s.known && returnReduce(same, andOp<bool>()))   // known: the same on all ranks
        {
            return tmp<vectorField>(new vectorField(s.values));
        }
    }

    sampled& s = recent_[oldest_];
    oldest_ = 1 - oldest_;
    s.cells = cells;
    s.values = sample<vector>(cells);
    s.known = true;
    return tmp<vectorField>(new vectorField(s.values));
}


Foam::tmp<Foam::scalarField> Foam::demTransfer::findOwnWeights() const
{
    tmp<scalarField> tq(new scalarField(routing_().locations().size()));
    kernel_().ownWeights(routing_().locations(), tq.ref());
    routing_().toParticles(tq.ref());
    return tq;
}


Foam::tmp<Foam::scalarField> Foam::demTransfer::sampleSolidForLaw() const
{
    scalarField solid(lawSolid_);
    kernel_().smoothForLaw(solid);
    return gather<scalar>(solid);
}


template<class Type>
void Foam::demTransfer::spread(const UList<Type>& perParticle, Field<Type>& density) const
{
    List<Type> values(perParticle);
    if (wedge_.valid())
    {
        wedge_().toSector(values);
    }
    routing_().toMesh(values);

    density.setSize(mesh_.nCells());
    density = Zero;
    kernel_().spread(routing_().locations(), values, density);
    density /= mesh_.V().field();
}


template<class Type>
void Foam::demTransfer::deposit(const UList<Type>& perParticle, Field<Type>& density) const
{
    spread(perParticle, density);
    kernel_().smooth(density);
    limiter_().spread(density);
}


template<class Type>
void Foam::demTransfer::removeShortWaves(Field<Type>& cells) const
{
    if (!shortWaves_.valid())
    {
        shortWaves_.reset(new demSmoother(mesh_, wedge_.get(), interface_.get()));
        // s, with half the variance of S; -1/16 adds h^2/16
        shortWaves_().setWidth(width_*diameter_/(3*std::sqrt(2.0)), -1.0/16.0, 0);
    }
    // S = s s: no wave changes its sign
    const auto smooth = [&](Field<Type>& values)
    {
        shortWaves_().smooth(values);
        shortWaves_().smooth(values);
    };
    smooth(cells);

    Field<Type> twice(cells);
    smooth(twice);
    cells += cells - twice;
}


void Foam::demTransfer::depositVolume
(
    const UList<scalar>& volumes,
    volScalarField::Internal& solid
)
{
    forget();
    spread(volumes, solid.field());
    if (lawWidth_ > 0)
    {
        lawSolid_ = solid.field();
        kernel_().smoothForLaw(lawSolid_);
    }
    kernel_().smooth(solid.field());
    limiter_().limitSolid(solid.field(), 1 - minVoidFraction_);
}


#define INSTANTIATE(Type)                                                      \
                                                                               \
template Foam::tmp<Foam::Field<Foam::Type>>                                    \
Foam::demTransfer::sample(const UList<Type>&) const;                           \
                                                                               \
template void Foam::demTransfer::removeShortWaves(Field<Type>&) const;         \
                                                                               \
template void Foam::demTransfer::deposit                                       \
(const UList<Type>&, Field<Type>&) const;

INSTANTIATE(scalar)
INSTANTIATE(vector)

#undef INSTANTIATE
