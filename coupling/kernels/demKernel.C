/*---------------------------------------------------------------------------*\
    demKernel.C -- selection of kernels, and the kernels of few lines: linear,
    particleCentre, diffusion.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demKernel.H"
#include "demCheck.H"
#include "demEvenBed.H"
#include "demSmoother.H"
#include "mathematicalConstants.H"
#include "volFields.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{

defineTypeNameAndDebug(demKernel, 0);
defineRunTimeSelectionTable(demKernel, parts);


autoPtr<demKernel> demKernel::New(const parts& p, const char* entry, const word& otherwise)
{
    const word name(p.coupling.getOrDefault<word>(entry, otherwise));
    const auto iter = partsConstructorTablePtr_->cfind(name);

    if (!iter.found())
    {
        demUnknown(p.coupling, "coupling", entry, name, partsConstructorTablePtr_->sortedToc());
    }
    return iter.val()(p);
}


// * * * * * * * * * * * * * * * * linear  * * * * * * * * * * * * * * * * * * //

//- Linear weights (demLinearWeights). They reproduce linear fields; when smoothed, cells
//  first pass on the excess that these weights give them in an even bed
class demLinearKernel
:
    public demKernel
{
    demLinearWeights weights_;

    //- In a wedge particles are in its middle plane, where volumes of cells are no measure
    const bool canBeEven_;

    //- Null unless smoothed
    autoPtr<demEvenBed> even_;

    const fvMesh& mesh_;

    template<class Type>
    void deposit
    (
        const UList<demCellLocation>& at, const UList<Type>& values, UList<Type>& cells
    ) const
    {
        weights_.spread(at, values, cells);
        if (even_.valid())
        {
            even_().apply(cells);
        }
    }

    template<class Type>
    void sample(const UList<demCellLocation>& at, UList<Type>& cells, UList<Type>& values) const
    {
        if (even_.valid())
        {
            even_().applyAdjoint(cells);
        }
        weights_.collect(at, cells, values);
    }


public:

    TypeName("linear");

    demLinearKernel(const parts& p)
    :
        weights_(p.mesh, p.sliding),
        canBeEven_(!p.wedge),
        mesh_(p.mesh)
    {}

    //- Mean variance over the positions in a cell, beyond the variance of a cell value
    //  that is a mean over the cell. In one direction the points, edges and faces of a box
    //  are half a cell from its centre and have on average 3/4 of the weight, the centre
    //  1/4. That gives 3/8, less 1/12 for the particle's position in the cell and 1/12 for
    //  the size of the cell.
    virtual bool variance(const scalar, scalar& c, scalar& a) const
    {
        c = 5.0/24.0;
        a = 0;
        return true;
    }

    virtual void setSmoothed()
    {
        if (canBeEven_)
        {
            even_.reset(new demEvenBed(weights_));
        }
    }

    virtual scalar surfaceLayer(const scalar) const
    {
        return 0.5*std::cbrt(gAverage(mesh_.V().field()));
    }

    virtual void ownWeights(const UList<demCellLocation>& at, UList<scalar>& q) const
    {
        weights_.ownWeights(at, q);
    }

    demKernelTransfers(scalar)
    demKernelTransfers(vector)
};


// * * * * * * * * * * * * * * *  particleCentre * * * * * * * * * * * * * * * //

//- All in the particle's cell: discontinuous in time, for comparison only
class demCentreKernel
:
    public demKernel
{
    const fvMesh& mesh_;

    template<class Type>
    void deposit
    (
        const UList<demCellLocation>& at, const UList<Type>& values, UList<Type>& cells
    ) const
    {
        forAll(at, i)
        {
            cells[at[i].cell] += values[i];
        }
    }

    template<class Type>
    void sample(const UList<demCellLocation>& at, UList<Type>& cells, UList<Type>& values) const
    {
        forAll(at, i)
        {
            values[i] = cells[at[i].cell];
        }
    }


public:

    TypeName("particleCentre");

    demCentreKernel(const parts& p)
    :
        mesh_(p.mesh)
    {}

    virtual void ownWeights(const UList<demCellLocation>& at, UList<scalar>& q) const
    {
        forAll(at, i)
        {
            q[i] = 1/mesh_.V()[at[i].cell];
        }
    }

    virtual bool variance(const scalar, scalar& c, scalar& a) const
    {
        c = a = 0;
        return true;
    }

    demKernelTransfers(scalar)
    demKernelTransfers(vector)
};


// * * * * * * * * * * * * * * * * diffusion * * * * * * * * * * * * * * * * * //

//- Another kernel, smoothed over the width (demSmoother)
class demDiffusionKernel
:
    public demKernel
{
    autoPtr<demKernel> base_;
    demSmoother smoother_;
    demSmoother lawSmoother_;
    const fvMesh& mesh_;

    //- Width, and width for drag laws [m]
    scalar b_, lawB_;

    //- Diameter [m]
    scalar d_;

    //- Squares of the sides of the cell, of a box along the axes [m2]
    vector squaredSides(const label celli) const
    {
        const labelList& corners = mesh_.cellPoints()[celli];
        vector sum(Zero);

        for (const label pointi : corners)
        {
            const vector d(mesh_.points()[pointi] - mesh_.cellCentres()[celli]);
            sum += cmptMultiply(d, d);
        }
        return sum*(4.0/corners.size());
    }

    //- q for a Gaussian of width b [m] that deposits and samples. Variance in each direction:
    //  b^2 plus h^2/6 for the two cells, at least 0.53 h^2 as for the base. Within 3 % away
    //  from walls
    void ofGaussian(const UList<demCellLocation>& at, const scalar b, UList<scalar>& q) const
    {
        forAll(at, i)
        {
            const vector h2(squaredSides(at[i].cell));
            q[i] = 1;
            for (direction k = 0; k < 3; ++k)
            {
                const scalar variance = max(sqr(b) + h2[k]/6, 0.53*h2[k]);
                q[i] /= std::sqrt(constant::mathematical::twoPi*variance);
            }
        }
    }

    template<class Type>
    void deposit
    (
        const UList<demCellLocation>& at, const UList<Type>& values, UList<Type>& cells
    ) const
    {
        base_().spread(at, values, cells);
    }

    template<class Type>
    void sample(const UList<demCellLocation>& at, UList<Type>& cells, UList<Type>& values) const
    {
        base_().collect(at, cells, values);
    }


public:

    TypeName("diffusion");

    demDiffusionKernel(const parts& p)
    :
        smoother_(p.mesh, p.wedge, p.sliding),
        lawSmoother_(p.mesh, p.wedge, p.sliding),
        mesh_(p.mesh),
        b_(0),
        lawB_(0),
        d_(0)
    {
        scalar c, a;
        const bool itself = p.coupling.getOrDefault<word>("base", "linear") == typeName;

        if (!itself)
        {
            base_ = New(p, "base", "linear");
        }
        if (itself || !base_().variance(0, c, a))
        {
            FatalIOErrorInFunction(p.coupling)
                << "coupling/base " << p.coupling.get<word>("base") << " has a width of its own"
                << " and cannot be smoothed; give linear, divided or particleCentre"
                << exit(FatalIOError);
        }
        base_().setSmoothed();
    }

    virtual bool uses(const word&) const
    {
        return true;
    }

    virtual void setWidth(const scalar d, const scalar b)
    {
        scalar c, a;
        base_().variance(d, c, a);
        smoother_.setWidth(b, c, a);
        b_ = b;
        d_ = d;
    }

    virtual void setLawWidth(const scalar b)
    {
        scalar c, a;
        base_().variance(d_, c, a);
        lawSmoother_.setWidth(b, c, a);
        lawB_ = b;
    }

    virtual void ownWeights(const UList<demCellLocation>& at, UList<scalar>& q) const
    {
        if (b_ <= 0)
        {
            base_().ownWeights(at, q);
            return;
        }
        ofGaussian(at, b_, q);
    }

    virtual void ownLawWeights(const UList<demCellLocation>& at, UList<scalar>& q) const
    {
        if (lawSmoother_.steps())
        {
            ofGaussian(at, lawB_, q);
            return;
        }
        base_().ownWeights(at, q);
    }

    virtual void smoothForLaw(UList<scalar>& density) const
    {
        lawSmoother_.smooth(density);
    }

    virtual scalar surfaceLayer(const scalar d) const
    {
        return base_().surfaceLayer(d);
    }

    virtual void update(const demView& view, const demParticleRouting& routing)
    {
        base_().update(view, routing);
    }

    virtual void smooth(UList<scalar>& density) const
    {
        smoother_.smooth(density);
    }

    virtual void smooth(UList<vector>& density) const
    {
        smoother_.smooth(density);
    }

    demKernelTransfers(scalar)
    demKernelTransfers(vector)
};


defineTypeNameAndDebug(demLinearKernel, 0);
defineTypeNameAndDebug(demCentreKernel, 0);
defineTypeNameAndDebug(demDiffusionKernel, 0);
addToRunTimeSelectionTable(demKernel, demLinearKernel, parts);
addToRunTimeSelectionTable(demKernel, demCentreKernel, parts);
addToRunTimeSelectionTable(demKernel, demDiffusionKernel, parts);

} // End namespace Foam
