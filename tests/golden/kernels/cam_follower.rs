/// Plate cam at constant speed that lifts a roller follower against a spring. The lift is a table of the cycloidal law.
///
/// The fields are its parameters, in SI units; the methods are its kernels.
///
/// # Equations of motion
///
/// ```text
/// [
///     mass_matrix, transpose(constraint_jacobian);
///     constraint_jacobian, 0
/// ] * [accelerations; multipliers] = [
///     generalized_forces - convective_forces;
///     -constraint_convective
/// ]
/// coordinates = [alpha; y]
/// multipliers = [lambda_drive; lambda_contact]
/// constraints = 0
/// [
///     J, 0, 1, lift'(alpha);
///     0, m, 0, -sin(pi/2);
///     1, 0, 0, 0;
///     lift'(alpha), -sin(pi/2), 0, 0
/// ] * [
///     alpha_ddot;
///     y_ddot;
///     lambda_drive;
///     lambda_contact
/// ] = [
///     0;
///     -F0 - k*(y - r) - m*g;
///     0;
///     -alpha_dot^2*lift''(alpha)
/// ]
///
/// mass_matrix = [J, 0; 0, m]
///
/// convective_forces = [0; 0]
///
/// generalized_forces = [0; -F0 - k*(y - r) - m*g]
///
/// constraints = [alpha - t*w; r + lift(alpha) - y*sin(pi/2)]
///
/// constraint_jacobian = [1, 0; lift'(alpha), -sin(pi/2)]
///
/// constraint_convective = [0; alpha_dot^2*lift''(alpha)]
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct CamFollower<S = ::core::primitive::f64> {
    /// Speed of the cam, in `1/s`.
    pub w: S,
    /// Radius of the base circle and that of the roller together, in `m`.
    pub r: S,
    /// Inertia of the cam and its shaft, in `kg*m^2`.
    pub J: S,
    /// Mass of the follower, in `kg`.
    pub m: S,
    /// Stiffness of the spring, in `N/m`.
    pub k: S,
    /// Force of the spring where the follower is down, in `N`.
    pub F0: S,
    /// Radius of the roller, for drawings, in `m`.
    pub roller: S,
    /// In `m/s^2`.
    pub g: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for CamFollower<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Mechanism<S>>::defaults()
    }
}
/// Coordinates of [`CamFollower`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct CamFollowerCoordinates<S = ::core::primitive::f64> {
    /// Angle of the cam, in `rad`.
    pub alpha: S,
    /// Height of the roller, in `m`.
    pub y: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 2]> for CamFollowerCoordinates<S> {
    fn from(values: [S; 2]) -> Self {
        Self {
            alpha: values[0],
            y: values[1],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<CamFollowerCoordinates<S>> for [S; 2] {
    fn from(record: CamFollowerCoordinates<S>) -> Self {
        [record.alpha, record.y]
    }
}
/// Outputs of [`CamFollower`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct CamFollowerOutputs<S = ::core::primitive::f64> {
    /// lift, in `m`.
    pub s: S,
    /// acceleration, in `m/s^2`.
    pub a: S,
    /// contact, in `N`.
    pub N: S,
    /// drive, in `N*m`.
    pub T: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 4]> for CamFollowerOutputs<S> {
    fn from(values: [S; 4]) -> Self {
        Self {
            s: values[0],
            a: values[1],
            N: values[2],
            T: values[3],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<CamFollowerOutputs<S>> for [S; 4] {
    fn from(record: CamFollowerOutputs<S>) -> Self {
        [record.s, record.a, record.N, record.T]
    }
}
/// Rates of the outputs of [`CamFollower`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct CamFollowerOutputRates<S = ::core::primitive::f64> {
    /// Rate of `s`.
    pub s: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 1]> for CamFollowerOutputRates<S> {
    fn from(values: [S; 1]) -> Self {
        Self { s: values[0] }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<CamFollowerOutputRates<S>> for [S; 1] {
    fn from(record: CamFollowerOutputRates<S>) -> Self {
        [record.s]
    }
}
/// What the equations of motion need of the parameters of [`CamFollower`], from [`CamFollower::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct CamFollowerPrepared<S = ::core::primitive::f64> {
    J: S,
    m: S,
    k: S,
    r: S,
    k_2: S,
    inverse_alpha: S,
    inverse_y: S,
    minus_l_lambda_contact_y: S,
    k_3: S,
    pivot_lambda_drive: S,
    minus_inverse_lambda_drive: S,
    w: S,
    k_4: S,
    k_5: S,
}
#[allow(
    non_snake_case,
    non_upper_case_globals,
    unused_variables,
    unused_parens,
    clippy::all,
    clippy::pedantic
)]
impl<S: sim_kernel::Scalar> CamFollower<S> {
    /// Lift over the angle of the cam, in SI units.
    pub const TABLE_lift: sim_kernel::Table = sim_kernel::Table::new(
        &[
            0.0,
            0.06981317007977318,
            0.13962634015954636,
            0.20943951023931953,
            0.2792526803190927,
            0.3490658503988659,
            0.41887902047863906,
            0.4886921905584123,
            0.5585053606381855,
            0.6283185307179586,
            0.6981317007977318,
            0.767944870877505,
            0.8377580409572781,
            0.9075712110370513,
            0.9773843811168246,
            1.0471975511965976,
            1.117010721276371,
            1.186823891356144,
            1.2566370614359172,
            1.3264502315156905,
            1.3962634015954636,
            1.4660765716752369,
            1.53588974175501,
            1.605702911834783,
            1.6755160819145563,
            1.7453292519943295,
            1.8151424220741026,
            1.8849555921538759,
            1.9547687622336491,
            2.0245819323134224,
            2.0943951023931953,
            2.199114857512855,
            2.3038346126325147,
            2.408554367752175,
            2.5132741228718345,
            2.6179938779914944,
            2.7227136331111543,
            2.827433388230814,
            2.9321531433504737,
            3.036872898470133,
            ::core::f64::consts::PI,
            3.211405823669566,
            3.2812189937493397,
            3.3510321638291125,
            3.4208453339088853,
            3.490658503988659,
            3.560471674068432,
            3.630284844148205,
            3.7000980142279785,
            3.7699111843077517,
            3.839724354387525,
            3.9095375244672983,
            3.979350694547071,
            4.049163864626845,
            4.118977034706617,
            4.1887902047863905,
            4.258603374866164,
            4.328416544945937,
            4.39822971502571,
            4.468042885105484,
            4.537856055185257,
            4.607669225265029,
            4.6774823953448035,
            4.747295565424576,
            4.81710873550435,
            4.886921905584122,
            4.956735075663896,
            5.026548245743669,
            5.096361415823442,
            5.1661745859032155,
            5.235987755982989,
            5.340707511102648,
            5.445427266222309,
            5.550147021341967,
            5.654866776461628,
            5.759586531581287,
            5.8643062867009474,
            5.969026041820607,
            6.073745796940266,
            6.178465552059926,
            6.283185307179586,
        ],
        &[
            [0.0, 0.0, 0.0, 0.0, 0.0],
            [0.0, 0.0, 3.6940513741370074e-8, 6.109935103776268e-7, 0.00855920592364558],
            [
                0.06981317007977318,
                2.9179201571173435e-6,
                0.00012527184604789,
                0.00179324689019619,
                0.008189655986286168,
            ],
            [
                0.13962634015954636,
                2.319023261458978e-5,
                0.0004954025163516686,
                0.003508484428992474,
                0.0074562752984911225,
            ],
            [
                0.20943951023931953,
                7.741285945363284e-5,
                0.001094302301125639,
                0.0050701230757179885,
                0.006398601435143513,
            ],
            [
                0.2792526803190927,
                0.00018069793110530598,
                0.0018957830523986183,
                0.006410243026511025,
                0.005060854133998302,
            ],
            [
                0.3490658503988659,
                0.00034601331373462383,
                0.0028648197934779476,
                0.007470185837728265,
                0.0035020367931068268,
            ],
            [
                0.41887902047863906,
                0.000583615851262423,
                0.0039590600100835064,
                0.008203650708516641,
                0.0017901332085736423,
            ],
            [
                0.4886921905584123,
                0.0009006030920682227,
                0.005130680410896328,
                0.008578575330983504,
                3.6681416445195975e-10,
            ],
            [
                0.5585053606381855,
                0.0013006030920682226,
                0.006328475493507946,
                0.008578575407808908,
                -0.0017901346758324385,
            ],
            [
                0.6283185307179586,
                0.0017836158512624226,
                0.007500095883593898,
                0.008203650478040336,
                -0.0035020316577003383,
            ],
            [
                0.6981317007977318,
                0.002346013313734624,
                0.00859433614310694,
                0.007470186682809135,
                -0.005060873208374895,
            ],
            [
                0.767944870877505,
                0.0029806979311053057,
                0.009563372723283222,
                0.006410239876663953,
                -0.006398530273046128,
            ],
            [
                0.8377580409572781,
                0.003677412859453632,
                0.01036485407526087,
                0.005070134830025713,
                -0.007456540872501514,
            ],
            [
                0.9075712110370513,
                0.0044231902326145895,
                0.010963751618119251,
                0.003508440561609447,
                -0.008188664852347354,
            ],
            [
                0.9773843811168246,
                0.005202917920157118,
                0.011333890655380716,
                0.0017934106054200152,
                -0.008562904885384772,
            ],
            [
                1.0471975511965976,
                0.006,
                0.011459094334999725,
                -5.963540027744085e-16,
                -0.008562904885372615,
            ],
            [
                1.117010721276371,
                0.006797082079842883,
                0.0113338906553807,
                -0.0017934106054189468,
                -0.008188664852355948,
            ],
            [
                1.186823891356144,
                0.007576809767385409,
                0.010963751618119242,
                -0.0035084405616101926,
                -0.007456540872495083,
            ],
            [
                1.2566370614359172,
                0.008322587140546366,
                0.010364854075260851,
                -0.005070134830025183,
                -0.00639853027304753,
            ],
            [
                1.3264502315156905,
                0.009019302068894694,
                0.009563372723283252,
                -0.006410239876663565,
                -0.005060873208379182,
            ],
            [
                1.3962634015954636,
                0.009653986686265376,
                0.00859433614310693,
                -0.007470186682809831,
                -0.003502031657691073,
            ],
            [
                1.4660765716752369,
                0.010216384148737576,
                0.007500095883593902,
                -0.008203650478039108,
                -0.0017901346758402745,
            ],
            [
                1.53588974175501,
                0.010699396907931778,
                0.006328475493507979,
                -0.008578575407809567,
                3.668166559100045e-10,
            ],
            [
                1.605702911834783,
                0.011099396907931778,
                0.005130680410896305,
                -0.0085785753309837,
                0.0017901332085771987,
            ],
            [
                1.6755160819145563,
                0.011416384148737576,
                0.0039590600100834995,
                -0.008203650708516237,
                0.003502036793104324,
            ],
            [
                1.7453292519943295,
                0.011653986686265376,
                0.0028648197934779563,
                -0.007470185837728382,
                0.005060854133999742,
            ],
            [
                1.8151424220741026,
                0.011819302068894694,
                0.00189578305239863,
                -0.006410243026510853,
                0.0063986014351404726,
            ],
            [
                1.8849555921538759,
                0.011922587140546368,
                0.001094302301125634,
                -0.005070123075718432,
                0.007456275298495325,
            ],
            [
                1.9547687622336491,
                0.01197680976738541,
                0.0004954025163516636,
                -0.00350848442899203,
                0.008189655986282652,
            ],
            [
                2.0245819323134224,
                0.011997082079842883,
                0.0001252718460478959,
                -0.0017932468901964722,
                0.008559205923647445,
            ],
            [
                2.0943951023931953,
                0.012,
                3.69405137352594e-8,
                -6.109935102769539e-7,
                2.4659873230474915e-6,
            ],
            [
                2.199114857512855,
                0.012,
                -9.89793669461478e-9,
                1.637192555162033e-7,
                -6.608201323199597e-7,
            ],
            [
                2.3038346126325147,
                0.012,
                2.651233043199791e-9,
                -4.388351178785815e-8,
                1.7729320623233325e-7,
            ],
            [
                2.408554367752175,
                0.012,
                -7.069954781843473e-10,
                1.1814791635229995e-8,
                -4.835269260938099e-8,
            ],
            [
                2.5132741228718345,
                0.012,
                1.767488695376086e-10,
                -3.375654753061646e-9,
                1.6117564205188658e-8,
            ],
            [
                2.6179938779914944,
                0.012,
                3.391446285068217e-20,
                1.6878273770166117e-9,
                -1.6117564211373915e-8,
            ],
            [
                2.7227136331111543,
                0.012,
                -1.7674886967326641e-10,
                -3.375654755004801e-9,
                4.835269264030727e-8,
            ],
            [
                2.827433388230814,
                0.012,
                7.069954786591497e-10,
                1.1814791643002615e-8,
                -1.7729320634985418e-7,
            ],
            [
                2.9321531433504737,
                0.012,
                -2.6512330449633377e-9,
                -4.388351181700557e-8,
                6.60820132759113e-7,
            ],
            [
                3.036872898470133,
                0.012,
                9.89793670119418e-9,
                1.6371925562501996e-7,
                -2.4659873246865837e-6,
            ],
            [
                ::core::f64::consts::PI,
                0.012,
                -3.6940513759813455e-8,
                -6.109935106827954e-7,
                -0.008559205923641698,
            ],
            [
                3.211405823669566,
                0.011997082079842881,
                -0.00012527184604789303,
                -0.0017932468901956777,
                -0.00818965598628891,
            ],
            [
                3.2812189937493397,
                0.01197680976738541,
                -0.000495402516351644,
                -0.003508484428992547,
                -0.0074562752984933724,
            ],
            [
                3.3510321638291125,
                0.011922587140546368,
                -0.0010943023011256536,
                -0.005070123075718537,
                -0.00639860143513735,
            ],
            [
                3.4208453339088853,
                0.011819302068894694,
                -0.0018957830523986135,
                -0.006410243026510291,
                -0.005060854134005696,
            ],
            [
                3.490658503988659,
                0.011653986686265376,
                -0.002864819793477958,
                -0.007470185837729083,
                -0.0035020367930992074,
            ],
            [
                3.560471674068432,
                0.011416384148737576,
                -0.003959060010083516,
                -0.008203650708515878,
                -0.0017901332085779105,
            ],
            [
                3.630284844148205,
                0.011099396907931778,
                -0.005130680410896294,
                -0.00857857533098359,
                -3.6681594406484684e-10,
            ],
            [
                3.7000980142279785,
                0.010699396907931778,
                -0.006328475493507952,
                -0.008578575407809267,
                0.001790134675835636,
            ],
            [
                3.7699111843077517,
                0.010216384148737576,
                -0.00750009588359391,
                -0.008203650478039727,
                0.0035020316576989032,
            ],
            [
                3.839724354387525,
                0.009653986686265376,
                -0.008594336143106882,
                -0.007470186682808552,
                0.005060873208361354,
            ],
            [
                3.9095375244672983,
                0.009019302068894695,
                -0.00956337272328328,
                -0.006410239876665822,
                0.0063985302730703904,
            ],
            [
                3.979350694547071,
                0.008322587140546367,
                -0.010364854075260842,
                -0.0050701348300225164,
                0.0074565408724686505,
            ],
            [
                4.049163864626845,
                0.00757680976738541,
                -0.01096375161811927,
                -0.0035084405616133433,
                0.008188664852379596,
            ],
            [
                4.118977034706617,
                0.006797082079842883,
                -0.011333890655380797,
                -0.0017934106054168539,
                0.008562904885362651,
            ],
            [
                4.1887902047863905,
                0.006,
                -0.011459094334999679,
                -7.951386703658781e-16,
                0.008562904885382581,
            ],
            [
                4.258603374866164,
                0.005202917920157118,
                -0.011333890655380697,
                0.0017934106054196368,
                0.00818866485234949,
            ],
            [
                4.328416544945937,
                0.00442319023261459,
                -0.010963751618119235,
                0.0035084405616094723,
                0.00745654087250149,
            ],
            [
                4.39822971502571,
                0.003677412859453633,
                -0.010364854075260856,
                0.005070134830025505,
                0.0063985302730489545,
            ],
            [
                4.468042885105484,
                0.0029806979311053066,
                -0.00956337272328319,
                0.0064102398766642905,
                0.005060873208362777,
            ],
            [
                4.537856055185257,
                0.0023460133137346243,
                -0.008594336143107013,
                0.007470186682807169,
                0.003502031657723907,
            ],
            [
                4.607669225265029,
                0.001783615851262423,
                -0.00750009588359389,
                0.008203650478043462,
                0.001790134675801066,
            ],
            [
                4.6774823953448035,
                0.0013006030920682228,
                -0.006328475493507914,
                0.008578575407805598,
                -3.6678640249091097e-10,
            ],
            [
                4.747295565424576,
                0.0009006030920682227,
                -0.005130680410896357,
                0.008578575330986077,
                -0.0017901332085949492,
            ],
            [
                4.81710873550435,
                0.0005836158512624225,
                -0.00395906001008347,
                0.0082036507085148,
                -0.0035020367930932014,
            ],
            [
                4.886921905584122,
                0.00034601331373462383,
                -0.0028648197934779806,
                0.007470185837729328,
                -0.0050608541340057605,
            ],
            [
                4.956735075663896,
                0.0001806979311053062,
                -0.0018957830523986074,
                0.0064102430265105545,
                -0.006398601435139672,
            ],
            [
                5.026548245743669,
                7.741285945363262e-5,
                -0.0010943023011256402,
                0.0050701230757183085,
                -0.007456275298494614,
            ],
            [
                5.096361415823442,
                2.319023261458978e-5,
                -0.0004954025163516759,
                0.003508484428992052,
                -0.008189655986281763,
            ],
            [
                5.1661745859032155,
                2.9179201571162593e-6,
                -0.00012527184604789162,
                0.0017932468901966845,
                -0.008559205923649137,
            ],
            [
                5.235987755982989,
                0.0,
                -3.694051372602976e-8,
                6.109935101242978e-7,
                -2.465987322431372e-6,
            ],
            [
                5.340707511102648,
                0.0,
                9.897936692141875e-9,
                -1.6371925547529635e-7,
                6.608201321548309e-7,
            ],
            [
                5.445427266222309,
                0.0,
                -2.6512330425376045e-9,
                4.388351177689013e-8,
                -1.7729320618797946e-7,
            ],
            [
                5.550147021341967,
                0.0,
                7.069954780086207e-10,
                -1.1814791632262908e-8,
                4.8352692597071894e-8,
            ],
            [
                5.654866776461628,
                0.0,
                -1.7674886949685746e-10,
                3.3756547521618414e-9,
                -1.611756420031222e-8,
            ],
            [
                5.759586531581287,
                0.0,
                -2.1187940584861703e-20,
                -1.6878273763844151e-9,
                1.6117564204176295e-8,
            ],
            [
                5.8643062867009474,
                0.0,
                1.7674886958161067e-10,
                3.3756547533758195e-9,
                -4.8352692616393635e-8,
            ],
            [
                5.969026041820607,
                0.0,
                -7.069954783052516e-10,
                -1.181479163711891e-8,
                1.772932062613983e-7,
            ],
            [
                6.073745796940266,
                0.0,
                2.6512330436393962e-9,
                4.388351179509979e-8,
                -6.608201324291993e-7,
            ],
            [
                6.178465552059926,
                0.0,
                -9.897936696252331e-9,
                -1.6371925554328033e-7,
                2.465987323455371e-6,
            ],
            [6.283185307179586, 0.0, 0.0, 0.0, 0.0],
        ],
        6.283185307179586,
    );
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 2 additions, 6 multiplications, 3 divisions, 1 sine-cosine pair.
    #[inline]
    pub fn prepare(&self) -> CamFollowerPrepared<S> {
        let inverse_J = S::from_f64(1.0) / self.J;
        let inverse_m = S::from_f64(1.0) / self.m;
        let ([minus_contact_by_y], [_]) = S::sin_cos_each([
            S::from_f64(0.5) * S::from_f64(::core::f64::consts::PI),
        ]);
        let w = minus_contact_by_y * inverse_m;
        CamFollowerPrepared {
            J: self.J,
            m: self.m,
            k: self.k,
            r: self.r,
            k_2: self.F0 + self.m * self.g,
            inverse_alpha: inverse_J,
            inverse_y: inverse_m,
            minus_l_lambda_contact_y: w,
            k_3: minus_contact_by_y * w,
            pivot_lambda_drive: -inverse_J,
            minus_inverse_lambda_drive: S::from_f64(1.0) / inverse_J,
            w: self.w,
            k_4: self.k * w,
            k_5: self.k * inverse_m,
        }
    }
    /// Mass matrix `T_q' M T_q`, 2 x 2, symmetric, in SI units.
    ///
    /// Operations: none.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 2]) -> [[S; 2]; 2] {
        [[self.J, S::from_f64(0.0)], [S::from_f64(0.0), self.m]]
    }
    /// Convective forces `T_q' M g`, 2, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.
    ///
    /// Operations: none.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 2] {
        [S::from_f64(0.0), S::from_f64(0.0)]
    }
    /// Generalised forces `T_q' F`, 2: joules per unit of each coordinate.
    ///
    /// Operations: 4 additions, 2 multiplications.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 2] {
        let [_, y] = *q;
        [S::from_f64(0.0), -(self.F0 + self.m * self.g + self.k * (y - self.r))]
    }
    /// Constraints `C`, 2, in SI units; zero throughout the motion.
    ///
    /// Operations: 3 additions, 3 multiplications, 1 sine-cosine pair, 1 table look-up.
    #[inline]
    pub fn constraints(&self, t: S, q: &[S; 2]) -> [S; 2] {
        let [alpha, y] = *q;
        let [lift] = CamFollower::<S>::TABLE_lift.at(alpha);
        let ([w], [_]) = S::sin_cos_each([
            S::from_f64(0.5) * S::from_f64(::core::f64::consts::PI),
        ]);
        [alpha - t * self.w, self.r + lift - y * w]
    }
    /// The sum of the magnitudes of the terms of `C`, 2, in SI units: what its rounding is relative to.
    ///
    /// Operations: 8 additions, 3 multiplications, 1 sine-cosine pair, 1 table look-up.
    #[inline]
    pub fn constraint_magnitudes(&self, t: S, q: &[S; 2]) -> [S; 2] {
        let [alpha, y] = *q;
        let [lift] = CamFollower::<S>::TABLE_lift.at(alpha);
        let ([w], [_]) = S::sin_cos_each([
            S::from_f64(0.5) * S::from_f64(::core::f64::consts::PI),
        ]);
        [alpha.abs() + (t * self.w).abs(), self.r.abs() + lift.abs() + (y * w).abs()]
    }
    /// Constraint Jacobian `C_q`, 2 x 2: units of each constraint per unit of each coordinate.
    ///
    /// Operations: 1 addition, 1 multiplication, 1 sine-cosine pair, 1 table look-up.
    #[inline]
    pub fn constraint_jacobian(&self, t: S, q: &[S; 2]) -> [[S; 2]; 2] {
        let [alpha, _] = *q;
        let [_, contact_by_alpha] = CamFollower::<S>::TABLE_lift.at(alpha);
        let ([minus_contact_by_y], [_]) = S::sin_cos_each([
            S::from_f64(0.5) * S::from_f64(::core::f64::consts::PI),
        ]);
        [[S::from_f64(1.0), S::from_f64(0.0)], [contact_by_alpha, -minus_contact_by_y]]
    }
    /// `C_t`, 2, units of `C` per second: the speeds obey `C_q q' + C_t = 0`.
    ///
    /// Operations: 1 addition.
    #[inline]
    pub fn constraint_time_derivative(&self, t: S, q: &[S; 2]) -> [S; 2] {
        [-self.w, S::from_f64(0.0)]
    }
    /// `(C_q q' + C_t)_q q' + (..)_t`, 2, units of `C` per second squared: the part of `C''` without accelerations.
    ///
    /// Operations: 2 multiplications, 1 table look-up.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 2] {
        let [alpha, _] = *q;
        let [alpha_dot, _] = *qd;
        let [_, _, lift_curvature] = CamFollower::<S>::TABLE_lift.at(alpha);
        [S::from_f64(0.0), alpha_dot * alpha_dot * lift_curvature]
    }
    /// `C` (2), `C_q` (2 x 2) and `C_t` (2) together, in SI units, for projection.
    ///
    /// Operations: 5 additions, 3 multiplications, 1 sine-cosine pair, 1 table look-up.
    #[inline]
    pub fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 2],
    ) -> sim_kernel::ConstraintLinearization<[S; 2], [[S; 2]; 2]> {
        let [alpha, y] = *q;
        let [lift, contact_by_alpha] = CamFollower::<S>::TABLE_lift.at(alpha);
        let ([minus_contact_by_y], [_]) = S::sin_cos_each([
            S::from_f64(0.5) * S::from_f64(::core::f64::consts::PI),
        ]);
        sim_kernel::ConstraintLinearization {
            values: [alpha - t * self.w, self.r + lift - y * minus_contact_by_y],
            jacobian: [
                [S::from_f64(1.0), S::from_f64(0.0)],
                [contact_by_alpha, -minus_contact_by_y],
            ],
            time_derivative: [-self.w, S::from_f64(0.0)],
        }
    }
    /// Kinetic energy `v' M v / 2`, in joules.
    ///
    /// Operations: 1 addition, 6 multiplications.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> S {
        let [alpha_dot, y_dot] = *qd;
        alpha_dot * alpha_dot * S::from_f64(0.5) * self.J
            + y_dot * y_dot * S::from_f64(0.5) * self.m
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: 5 additions, 4 multiplications.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 2],
    ) -> S {
        let [_, y] = *q;
        let [_, y_dot] = *qd;
        let [lambda_drive, _] = *lambda;
        -(y_dot * (self.F0 + self.m * self.g + self.k * (y - self.r))
            + self.w * lambda_drive)
    }
    /// Outputs, 4, in SI units.
    ///
    /// Operations: 2 additions.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 2],
    ) -> CamFollowerOutputs<S> {
        let [_, y] = *q;
        let [_, y_ddot] = *qdd;
        let [lambda_drive, lambda_contact] = *lambda;
        [y - self.r, y_ddot, lambda_contact, -lambda_drive].into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 1, in SI units per second.
    ///
    /// Operations: none.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
    ) -> CamFollowerOutputRates<S> {
        let [_, y_dot] = *qd;
        [y_dot].into()
    }
    /// `left - right` of each event, 2, in SI units: zero when it happens.
    ///
    /// Operations: 1 addition, 1 multiplication.
    #[inline]
    pub fn events(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 2],
    ) -> [S; 2] {
        let [alpha, _] = *q;
        let [_, lambda_contact] = *lambda;
        [alpha - S::from_f64(2.0) * S::from_f64(::core::f64::consts::PI), lambda_contact]
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 76 additions, 111 multiplications, 37 sine-cosine pairs, 37 table look-ups.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 2]) -> [S; 168] {
        let [alpha, y] = *q;
        let top_y = S::from_f64(4.0) * self.r;
        let [lift] = CamFollower::<S>::TABLE_lift.at(S::from_f64(0.0));
        let w = self.r + lift;
        let w_2 = S::from_f64(0.05555555555555555)
            * S::from_f64(::core::f64::consts::PI);
        let w_3 = w_2 - alpha;
        let [lift_2] = CamFollower::<S>::TABLE_lift.at(w_2);
        let w_4 = S::from_f64(::core::f64::consts::PI) * S::from_f64(0.1111111111111111);
        let w_5 = w_4 - alpha;
        let [lift_3] = CamFollower::<S>::TABLE_lift.at(w_4);
        let w_6 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(0.16666666666666666);
        let w_7 = w_6 - alpha;
        let [lift_4] = CamFollower::<S>::TABLE_lift.at(w_6);
        let w_8 = S::from_f64(::core::f64::consts::PI) * S::from_f64(0.2222222222222222);
        let w_9 = w_8 - alpha;
        let [lift_5] = CamFollower::<S>::TABLE_lift.at(w_8);
        let w_10 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(0.2777777777777778);
        let w_11 = w_10 - alpha;
        let [lift_6] = CamFollower::<S>::TABLE_lift.at(w_10);
        let w_12 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(0.3333333333333333);
        let w_13 = w_12 - alpha;
        let [lift_7] = CamFollower::<S>::TABLE_lift.at(w_12);
        let w_14 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(0.3888888888888889);
        let w_15 = w_14 - alpha;
        let [lift_8] = CamFollower::<S>::TABLE_lift.at(w_14);
        let w_16 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(0.4444444444444444);
        let w_17 = w_16 - alpha;
        let [lift_9] = CamFollower::<S>::TABLE_lift.at(w_16);
        let w_18 = S::from_f64(::core::f64::consts::PI) * S::from_f64(0.5);
        let w_19 = w_18 - alpha;
        let w_20 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(0.5555555555555556);
        let w_21 = w_20 - alpha;
        let [lift_11] = CamFollower::<S>::TABLE_lift.at(w_20);
        let w_22 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(0.6111111111111112);
        let w_23 = w_22 - alpha;
        let [lift_12] = CamFollower::<S>::TABLE_lift.at(w_22);
        let w_24 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(0.6666666666666666);
        let w_25 = w_24 - alpha;
        let [lift_13] = CamFollower::<S>::TABLE_lift.at(w_24);
        let w_26 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(0.7222222222222222);
        let w_27 = w_26 - alpha;
        let [lift_14] = CamFollower::<S>::TABLE_lift.at(w_26);
        let w_28 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(0.7777777777777778);
        let w_29 = w_28 - alpha;
        let [lift_15] = CamFollower::<S>::TABLE_lift.at(w_28);
        let w_30 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(0.8333333333333334);
        let w_31 = w_30 - alpha;
        let [lift_16] = CamFollower::<S>::TABLE_lift.at(w_30);
        let w_32 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(0.8888888888888888);
        let w_33 = w_32 - alpha;
        let [lift_17] = CamFollower::<S>::TABLE_lift.at(w_32);
        let w_34 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(0.9444444444444444);
        let w_35 = w_34 - alpha;
        let [lift_18] = CamFollower::<S>::TABLE_lift.at(w_34);
        let w_36 = S::from_f64(::core::f64::consts::PI) - alpha;
        let w_37 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(1.0555555555555556);
        let w_38 = w_37 - alpha;
        let [lift_20] = CamFollower::<S>::TABLE_lift.at(w_37);
        let w_39 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(1.1111111111111112);
        let w_40 = w_39 - alpha;
        let [lift_21] = CamFollower::<S>::TABLE_lift.at(w_39);
        let w_41 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(1.1666666666666667);
        let w_42 = w_41 - alpha;
        let [lift_22] = CamFollower::<S>::TABLE_lift.at(w_41);
        let w_43 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(1.2222222222222223);
        let w_44 = w_43 - alpha;
        let [lift_23] = CamFollower::<S>::TABLE_lift.at(w_43);
        let w_45 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(1.2777777777777777);
        let w_46 = w_45 - alpha;
        let [lift_24] = CamFollower::<S>::TABLE_lift.at(w_45);
        let w_47 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(1.3333333333333333);
        let w_48 = w_47 - alpha;
        let [lift_25] = CamFollower::<S>::TABLE_lift.at(w_47);
        let w_49 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(1.3888888888888888);
        let w_50 = w_49 - alpha;
        let [lift_26] = CamFollower::<S>::TABLE_lift.at(w_49);
        let w_51 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(1.4444444444444444);
        let w_52 = w_51 - alpha;
        let [lift_27] = CamFollower::<S>::TABLE_lift.at(w_51);
        let w_53 = S::from_f64(::core::f64::consts::PI) * S::from_f64(1.5);
        let w_54 = w_53 - alpha;
        let [lift_28] = CamFollower::<S>::TABLE_lift.at(w_53);
        let w_55 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(1.5555555555555556);
        let w_56 = w_55 - alpha;
        let [lift_29] = CamFollower::<S>::TABLE_lift.at(w_55);
        let w_57 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(1.6111111111111112);
        let w_58 = w_57 - alpha;
        let [lift_30] = CamFollower::<S>::TABLE_lift.at(w_57);
        let w_59 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(1.6666666666666667);
        let w_60 = w_59 - alpha;
        let [lift_31] = CamFollower::<S>::TABLE_lift.at(w_59);
        let w_61 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(1.7222222222222223);
        let w_62 = w_61 - alpha;
        let [lift_32] = CamFollower::<S>::TABLE_lift.at(w_61);
        let w_63 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(1.7777777777777777);
        let w_64 = w_63 - alpha;
        let [lift_33] = CamFollower::<S>::TABLE_lift.at(w_63);
        let w_65 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(1.8333333333333333);
        let w_66 = w_65 - alpha;
        let [lift_34] = CamFollower::<S>::TABLE_lift.at(w_65);
        let w_67 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(1.8888888888888888);
        let w_68 = w_67 - alpha;
        let [lift_35] = CamFollower::<S>::TABLE_lift.at(w_67);
        let w_69 = S::from_f64(::core::f64::consts::PI)
            * S::from_f64(1.9444444444444444);
        let w_70 = w_69 - alpha;
        let [lift_36] = CamFollower::<S>::TABLE_lift.at(w_69);
        let w_71 = S::from_f64(::core::f64::consts::PI) * S::from_f64(2.0);
        let w_72 = w_71 - alpha;
        let (
            [sin_alpha,
            sin_w_3,
            sin_w_5,
            sin_w_7,
            sin_w_9,
            sin_w_11,
            sin_w_13,
            sin_w_15,
            sin_w_17,
            sin_w_19,
            sin_w_21,
            sin_w_23,
            sin_w_25,
            sin_w_27,
            sin_w_29,
            sin_w_31,
            sin_w_33,
            sin_w_35,
            sin_w_36,
            sin_w_38,
            sin_w_40,
            sin_w_42,
            sin_w_44,
            sin_w_46,
            sin_w_48,
            sin_w_50,
            sin_w_52,
            sin_w_54,
            sin_w_56,
            sin_w_58,
            sin_w_60,
            sin_w_62,
            sin_w_64,
            sin_w_66,
            sin_w_68,
            sin_w_70,
            sin_w_72,
            ],
            [cos_alpha,
            cos_w_3,
            cos_w_5,
            cos_w_7,
            cos_w_9,
            cos_w_11,
            cos_w_13,
            cos_w_15,
            cos_w_17,
            cos_w_19,
            cos_w_21,
            cos_w_23,
            cos_w_25,
            cos_w_27,
            cos_w_29,
            cos_w_31,
            cos_w_33,
            cos_w_35,
            cos_w_36,
            cos_w_38,
            cos_w_40,
            cos_w_42,
            cos_w_44,
            cos_w_46,
            cos_w_48,
            cos_w_50,
            cos_w_52,
            cos_w_54,
            cos_w_56,
            cos_w_58,
            cos_w_60,
            cos_w_62,
            cos_w_64,
            cos_w_66,
            cos_w_68,
            cos_w_70,
            cos_w_72,
            ],
        ) = S::sin_cos_each([
            alpha,
            w_3,
            w_5,
            w_7,
            w_9,
            w_11,
            w_13,
            w_15,
            w_17,
            w_19,
            w_21,
            w_23,
            w_25,
            w_27,
            w_29,
            w_31,
            w_33,
            w_35,
            w_36,
            w_38,
            w_40,
            w_42,
            w_44,
            w_46,
            w_48,
            w_50,
            w_52,
            w_54,
            w_56,
            w_58,
            w_60,
            w_62,
            w_64,
            w_66,
            w_68,
            w_70,
            w_72,
        ]);
        let [lift_37] = CamFollower::<S>::TABLE_lift.at(w_71);
        let path_0_x = -(w * sin_alpha);
        let path_0_y = w * cos_alpha;
        let w_73 = self.r + lift_2;
        let path_1_x = w_73 * sin_w_3;
        let path_1_y = w_73 * cos_w_3;
        let w_74 = self.r + lift_3;
        let path_2_x = w_74 * sin_w_5;
        let path_2_y = w_74 * cos_w_5;
        let w_75 = self.r + lift_4;
        let path_3_x = w_75 * sin_w_7;
        let path_3_y = w_75 * cos_w_7;
        let w_76 = self.r + lift_5;
        let path_4_x = w_76 * sin_w_9;
        let path_4_y = w_76 * cos_w_9;
        let w_77 = self.r + lift_6;
        let path_5_x = w_77 * sin_w_11;
        let path_5_y = w_77 * cos_w_11;
        let w_78 = self.r + lift_7;
        let path_6_x = w_78 * sin_w_13;
        let path_6_y = w_78 * cos_w_13;
        let w_79 = self.r + lift_8;
        let path_7_x = w_79 * sin_w_15;
        let path_7_y = w_79 * cos_w_15;
        let w_80 = self.r + lift_9;
        let path_8_x = w_80 * sin_w_17;
        let path_8_y = w_80 * cos_w_17;
        let [lift_10] = CamFollower::<S>::TABLE_lift.at(w_18);
        let w_81 = self.r + lift_10;
        let path_9_x = w_81 * sin_w_19;
        let path_9_y = w_81 * cos_w_19;
        let w_82 = self.r + lift_11;
        let path_10_x = w_82 * sin_w_21;
        let path_10_y = w_82 * cos_w_21;
        let w_83 = self.r + lift_12;
        let path_11_x = w_83 * sin_w_23;
        let path_11_y = w_83 * cos_w_23;
        let w_84 = self.r + lift_13;
        let path_12_x = w_84 * sin_w_25;
        let path_12_y = w_84 * cos_w_25;
        let w_85 = self.r + lift_14;
        let path_13_x = w_85 * sin_w_27;
        let path_13_y = w_85 * cos_w_27;
        let w_86 = self.r + lift_15;
        let path_14_x = w_86 * sin_w_29;
        let path_14_y = w_86 * cos_w_29;
        let w_87 = self.r + lift_16;
        let path_15_x = w_87 * sin_w_31;
        let path_15_y = w_87 * cos_w_31;
        let w_88 = self.r + lift_17;
        let path_16_x = w_88 * sin_w_33;
        let path_16_y = w_88 * cos_w_33;
        let w_89 = self.r + lift_18;
        let path_17_x = w_89 * sin_w_35;
        let path_17_y = w_89 * cos_w_35;
        let [lift_19] = CamFollower::<S>::TABLE_lift
            .at(S::from_f64(::core::f64::consts::PI));
        let w_90 = self.r + lift_19;
        let path_18_x = w_90 * sin_w_36;
        let path_18_y = w_90 * cos_w_36;
        let w_91 = self.r + lift_20;
        let path_19_x = w_91 * sin_w_38;
        let path_19_y = w_91 * cos_w_38;
        let w_92 = self.r + lift_21;
        let path_20_x = w_92 * sin_w_40;
        let path_20_y = w_92 * cos_w_40;
        let w_93 = self.r + lift_22;
        let path_21_x = w_93 * sin_w_42;
        let path_21_y = w_93 * cos_w_42;
        let w_94 = self.r + lift_23;
        let path_22_x = w_94 * sin_w_44;
        let path_22_y = w_94 * cos_w_44;
        let w_95 = self.r + lift_24;
        let path_23_x = w_95 * sin_w_46;
        let path_23_y = w_95 * cos_w_46;
        let w_96 = self.r + lift_25;
        let path_24_x = w_96 * sin_w_48;
        let path_24_y = w_96 * cos_w_48;
        let w_97 = self.r + lift_26;
        let path_25_x = w_97 * sin_w_50;
        let path_25_y = w_97 * cos_w_50;
        let w_98 = self.r + lift_27;
        let path_26_x = w_98 * sin_w_52;
        let path_26_y = w_98 * cos_w_52;
        let w_99 = self.r + lift_28;
        let path_27_x = w_99 * sin_w_54;
        let path_27_y = w_99 * cos_w_54;
        let w_100 = self.r + lift_29;
        let path_28_x = w_100 * sin_w_56;
        let path_28_y = w_100 * cos_w_56;
        let w_101 = self.r + lift_30;
        let path_29_x = w_101 * sin_w_58;
        let path_29_y = w_101 * cos_w_58;
        let w_102 = self.r + lift_31;
        let path_30_x = w_102 * sin_w_60;
        let path_30_y = w_102 * cos_w_60;
        let w_103 = self.r + lift_32;
        let path_31_x = w_103 * sin_w_62;
        let path_31_y = w_103 * cos_w_62;
        let w_104 = self.r + lift_33;
        let path_32_x = w_104 * sin_w_64;
        let path_32_y = w_104 * cos_w_64;
        let w_105 = self.r + lift_34;
        let path_33_x = w_105 * sin_w_66;
        let path_33_y = w_105 * cos_w_66;
        let w_106 = self.r + lift_35;
        let path_34_x = w_106 * sin_w_68;
        let path_34_y = w_106 * cos_w_68;
        let w_107 = self.r + lift_36;
        let path_35_x = w_107 * sin_w_70;
        let path_35_y = w_107 * cos_w_70;
        let w_108 = self.r + lift_37;
        let w_109 = y + self.r * S::from_f64(1.5);
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            top_y,
            path_0_x,
            path_0_y,
            path_1_x,
            path_1_y,
            path_1_x,
            path_1_y,
            path_2_x,
            path_2_y,
            path_2_x,
            path_2_y,
            path_3_x,
            path_3_y,
            path_3_x,
            path_3_y,
            path_4_x,
            path_4_y,
            path_4_x,
            path_4_y,
            path_5_x,
            path_5_y,
            path_5_x,
            path_5_y,
            path_6_x,
            path_6_y,
            path_6_x,
            path_6_y,
            path_7_x,
            path_7_y,
            path_7_x,
            path_7_y,
            path_8_x,
            path_8_y,
            path_8_x,
            path_8_y,
            path_9_x,
            path_9_y,
            path_9_x,
            path_9_y,
            path_10_x,
            path_10_y,
            path_10_x,
            path_10_y,
            path_11_x,
            path_11_y,
            path_11_x,
            path_11_y,
            path_12_x,
            path_12_y,
            path_12_x,
            path_12_y,
            path_13_x,
            path_13_y,
            path_13_x,
            path_13_y,
            path_14_x,
            path_14_y,
            path_14_x,
            path_14_y,
            path_15_x,
            path_15_y,
            path_15_x,
            path_15_y,
            path_16_x,
            path_16_y,
            path_16_x,
            path_16_y,
            path_17_x,
            path_17_y,
            path_17_x,
            path_17_y,
            path_18_x,
            path_18_y,
            path_18_x,
            path_18_y,
            path_19_x,
            path_19_y,
            path_19_x,
            path_19_y,
            path_20_x,
            path_20_y,
            path_20_x,
            path_20_y,
            path_21_x,
            path_21_y,
            path_21_x,
            path_21_y,
            path_22_x,
            path_22_y,
            path_22_x,
            path_22_y,
            path_23_x,
            path_23_y,
            path_23_x,
            path_23_y,
            path_24_x,
            path_24_y,
            path_24_x,
            path_24_y,
            path_25_x,
            path_25_y,
            path_25_x,
            path_25_y,
            path_26_x,
            path_26_y,
            path_26_x,
            path_26_y,
            path_27_x,
            path_27_y,
            path_27_x,
            path_27_y,
            path_28_x,
            path_28_y,
            path_28_x,
            path_28_y,
            path_29_x,
            path_29_y,
            path_29_x,
            path_29_y,
            path_30_x,
            path_30_y,
            path_30_x,
            path_30_y,
            path_31_x,
            path_31_y,
            path_31_x,
            path_31_y,
            path_32_x,
            path_32_y,
            path_32_x,
            path_32_y,
            path_33_x,
            path_33_y,
            path_33_x,
            path_33_y,
            path_34_x,
            path_34_y,
            path_34_x,
            path_34_y,
            path_35_x,
            path_35_y,
            path_35_x,
            path_35_y,
            w_108 * sin_w_72,
            w_108 * cos_w_72,
            S::from_f64(0.0),
            S::from_f64(0.0),
            path_0_x,
            path_0_y,
            S::from_f64(0.0),
            y,
            self.roller,
            S::from_f64(0.0),
            y,
            S::from_f64(0.0),
            w_109,
            S::from_f64(0.0),
            self.r + y,
            w_18,
            S::from_f64(0.0),
            w_109,
            S::from_f64(0.0),
            top_y,
            S::from_f64(0.0),
            S::from_f64(0.0),
        ]
    }
    /// Declared start: values or guesses of the coordinates (2), and speeds (2), in SI units; 0 where nothing is declared.
    ///
    /// Operations: none.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 2]> {
        sim_kernel::Initial {
            positions: [S::from_f64(0.0), S::from_f64(0.04)],
            speeds: [S::from_f64(0.0), S::from_f64(0.0)],
        }
    }
    /// [`CamFollowerPrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::Dynamics<S, [S; 2], [S; 2]> {
        self.prepare().dynamics(t, q, qd)
    }
    /// [`CamFollowerPrepared::dynamics_jacobian`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 2]; 2], [[S; 2]; 2]> {
        self.prepare().dynamics_jacobian(t, q, qd)
    }
}
#[allow(
    non_snake_case,
    non_upper_case_globals,
    unused_variables,
    unused_parens,
    clippy::all,
    clippy::pedantic
)]
impl<S: sim_kernel::Scalar> CamFollowerPrepared<S> {
    /// Accelerations (2), multipliers (2) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 11 additions, 16 multiplications, 1 division, 1 table look-up.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::Dynamics<S, [S; 2], [S; 2]> {
        let [alpha, y] = *q;
        let [alpha_dot, y_dot] = *qd;
        let [_, contact_by_alpha, lift_curvature] = CamFollower::<S>::TABLE_lift
            .at(alpha);
        let l_lambda_contact_alpha = contact_by_alpha * self.inverse_alpha;
        let l_lambda_contact_lambda_drive = l_lambda_contact_alpha
            * self.minus_inverse_lambda_drive;
        let w = contact_by_alpha * l_lambda_contact_alpha + self.k_3;
        let pivot_lambda_contact = l_lambda_contact_alpha * l_lambda_contact_lambda_drive
            - w;
        let minus_rhs_y = self.k_2 + self.k * (y - self.r);
        let minus_lambda_contact = S::from_f64(1.0) / pivot_lambda_contact
            * (alpha_dot * alpha_dot * lift_curvature
                + minus_rhs_y * self.minus_l_lambda_contact_y);
        let lambda_drive = l_lambda_contact_lambda_drive * minus_lambda_contact;
        sim_kernel::Dynamics {
            accelerations: [
                l_lambda_contact_alpha * minus_lambda_contact
                    - self.inverse_alpha * lambda_drive,
                -(minus_rhs_y * self.inverse_y
                    + self.minus_l_lambda_contact_y * minus_lambda_contact),
            ],
            multipliers: [lambda_drive, -minus_lambda_contact],
            power: -(minus_rhs_y * y_dot + lambda_drive * self.w),
            refused: sim_kernel::pivot_is_refused(self.J, self.J)
                | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(
                    self.pivot_lambda_drive,
                    self.inverse_alpha,
                ) | sim_kernel::pivot_is_refused(pivot_lambda_contact, w),
        }
    }
    /// The derivatives of accelerations (2 rows) and multipliers (2 rows) with respect to coordinates and speeds (2 columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: 19 additions, 36 multiplications, 1 division, 1 table look-up.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 2]; 2], [[S; 2]; 2]> {
        let [alpha, y] = *q;
        let [alpha_dot, _] = *qd;
        let [_, contact_by_alpha, lift_curvature, lift_third] = CamFollower::<
            S,
        >::TABLE_lift
            .at(alpha);
        let l_lambda_contact_alpha = contact_by_alpha * self.inverse_alpha;
        let l_lambda_contact_lambda_drive = l_lambda_contact_alpha
            * self.minus_inverse_lambda_drive;
        let w = contact_by_alpha * l_lambda_contact_alpha + self.k_3;
        let pivot_lambda_contact = l_lambda_contact_alpha * l_lambda_contact_lambda_drive
            - w;
        let inverse_lambda_contact = S::from_f64(1.0) / pivot_lambda_contact;
        let alpha_dot_squared = alpha_dot * alpha_dot;
        let minus_lambda_contact = inverse_lambda_contact
            * (alpha_dot_squared * lift_curvature
                + (self.k_2 + self.k * (y - self.r)) * self.minus_l_lambda_contact_y);
        let w_2 = lift_curvature * minus_lambda_contact;
        let w_3 = self.inverse_alpha * w_2;
        let w_4 = inverse_lambda_contact
            * (l_lambda_contact_lambda_drive * w_3
                - (alpha_dot_squared * lift_third
                    + lift_curvature
                        * (l_lambda_contact_alpha * minus_lambda_contact
                            - self.inverse_alpha * l_lambda_contact_lambda_drive
                                * minus_lambda_contact)) - l_lambda_contact_alpha * w_2);
        let w_5 = self.minus_inverse_lambda_drive * w_3
            - l_lambda_contact_lambda_drive * w_4;
        let w_6 = inverse_lambda_contact * self.k_4;
        let w_7 = l_lambda_contact_lambda_drive * w_6;
        let w_8 = inverse_lambda_contact * alpha_dot * lift_curvature * S::from_f64(2.0);
        let w_9 = l_lambda_contact_lambda_drive * w_8;
        sim_kernel::DynamicsJacobian {
            accelerations_by_positions: [
                [
                    w_3 - self.inverse_alpha * w_5 - l_lambda_contact_alpha * w_4,
                    l_lambda_contact_alpha * w_6 - self.inverse_alpha * w_7,
                ],
                [
                    self.minus_l_lambda_contact_y * w_4,
                    -(self.k_5 + self.minus_l_lambda_contact_y * w_6),
                ],
            ],
            accelerations_by_speeds: [
                [
                    l_lambda_contact_alpha * w_8 - self.inverse_alpha * w_9,
                    S::from_f64(0.0),
                ],
                [-(self.minus_l_lambda_contact_y * w_8), S::from_f64(0.0)],
            ],
            multipliers_by_positions: [[w_5, w_7], [w_4, -w_6]],
            multipliers_by_speeds: [[w_9, S::from_f64(0.0)], [-w_8, S::from_f64(0.0)]],
            refused: sim_kernel::pivot_is_refused(self.J, self.J)
                | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(
                    self.pivot_lambda_drive,
                    self.inverse_alpha,
                ) | sim_kernel::pivot_is_refused(pivot_lambda_contact, w),
        }
    }
}
#[allow(non_snake_case, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for CamFollower<S> {
    type Q = [S; 2];
    type L = [S; 2];
    type Z = [S; 4];
    type QQ = [[S; 2]; 2];
    type LQ = [[S; 2]; 2];
    type LL = [[S; 2]; 2];
    type ZZ = [[S; 4]; 4];
    type Entries = [S; 0];
    type Envelope = [S; 0];
    type Parameters = [S; 8];
    type Outputs = [S; 4];
    type OutputRates = [S; 1];
    type Events = [S; 2];
    type EventValues = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 168];
    type QP = [[S; 8]; 2];
    type LP = [[S; 8]; 2];
    type Inputs = [sim_kernel::Input<S>; 0];
    type Prepared = CamFollowerPrepared<S>;
    type On<T: sim_kernel::Scalar> = CamFollower<T>;
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "cam-follower",
        type_name: "CamFollower",
        docs: "Plate cam at constant speed that lifts a roller follower against a spring. The lift is a table of the cycloidal law.",
        declaration: "/// Plate cam at constant speed that lifts a roller follower against a spring. The lift is a table of the cycloidal law.\npub CamFollower;\n\ncoordinates {\n    /// Angle of the cam.\n    alpha [rad];\n    /// Height of the roller.\n    y [mm];\n}\n\nparameters {\n    /// Speed of the cam.\n    w [rpm] = 300;\n    /// Radius of the base circle and that of the roller together.\n    r [mm] = 40;\n    /// Inertia of the cam and its shaft.\n    J [kg*m^2] = 0.002;\n    /// Mass of the follower.\n    m [kg] = 0.6;\n    /// Stiffness of the spring.\n    k [N/mm] = 2;\n    /// Force of the spring where the follower is down.\n    F0 [N] = 60;\n    /// Radius of the roller, for drawings.\n    roller [mm] = 10;\n    g [m/s^2] = 9.81;\n}\n\nconst n = 30;\n\ntables {\n    /// Lift over the angle of the cam.\n    lift [mm] over [deg] = cubic, periodic {\n        repeat i in 0..n { 120*i/n, 12*(i/n - sin(2*pi*i/n)/(2*pi)); }\n        repeat i in 0..=10 { 120 + 6*i, 12; }\n        repeat i in 1..n { 180 + 120*i/n, 12*(1 - i/n + sin(2*pi*i/n)/(2*pi)); }\n        repeat i in 0..=10 { 300 + 6*i, 0; }\n    }\n}\n\nlet O = [0, 0];\nlet P = [0, y];\n\nbodies {\n    cam: inertia J, angle alpha;\n    follower: mass m at P;\n}\n\nloads {\n    gravity [0, -g];\n    force -(k*(y - r) + F0) on y;\n}\n\nconstraints { drive: alpha = w*t; }\n\njoints { contact: cam P through O along pi/2 on cam radius r by lift; }\n\ninitial { guess y = 40; }\n\nevents {\n    period: alpha = 2*pi;\n    /// The follower loses touch with the cam.\n    float: reaction(contact) = 0 falling;\n}\n\noutputs {\n    follower_lift \"Lift of the follower\" {\n        /// lift\n        s [mm] = y - r;\n    }\n    follower_acceleration \"Acceleration of the follower\" {\n        /// acceleration\n        a [m/s^2] = ddot(y);\n    }\n    contact_force \"Force of the cam on the follower\" {\n        /// contact\n        N [N] = reaction(contact);\n    }\n    torque \"Torque of the drive\" {\n        /// drive\n        T [N*m] = -reaction(drive);\n    }\n}\n\nlet top = [0, 4*r];\n\nrepeat i in 0..=36 {\n    let path_[i] = (r + lift(10*i*pi/180))*[sin(10*i*pi/180 - alpha), cos(10*i*pi/180 - alpha)];\n}\n\ndrawing {\n    ground O, top;\n    repeat i in 1..=36 { curve path_[i-1], path_[i]; }\n    curve O, path_[0];\n    circle P radius roller;\n    line P, P + [0, 1.5*r];\n    slider P + [0, r] along pi/2;\n    spring P + [0, 1.5*r], top;\n    point O;\n}\n",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "alpha",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Angle of the cam.",
                },
                speed: sim_kernel::Quantity {
                    name: "alpha_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "alpha_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                start: sim_kernel::Start::Free,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "y",
                    unit: "mm",
                    factor: 0.001f64,
                    is_length: true,
                    docs: "Height of the roller.",
                },
                speed: sim_kernel::Quantity {
                    name: "y_dot",
                    unit: "mm/s",
                    factor: 0.001f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "y_ddot",
                    unit: "mm/s^2",
                    factor: 0.001f64,
                    is_length: false,
                    docs: "",
                },
                start: sim_kernel::Start::Guess,
                speed_given: false,
            },
        ],
        parameters: &[
            sim_kernel::Quantity {
                name: "w",
                unit: "rpm",
                factor: 0.10471975511965977f64,
                is_length: false,
                docs: "Speed of the cam.",
            },
            sim_kernel::Quantity {
                name: "r",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "Radius of the base circle and that of the roller together.",
            },
            sim_kernel::Quantity {
                name: "J",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "Inertia of the cam and its shaft.",
            },
            sim_kernel::Quantity {
                name: "m",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of the follower.",
            },
            sim_kernel::Quantity {
                name: "k",
                unit: "N/mm",
                factor: 1000f64,
                is_length: false,
                docs: "Stiffness of the spring.",
            },
            sim_kernel::Quantity {
                name: "F0",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "Force of the spring where the follower is down.",
            },
            sim_kernel::Quantity {
                name: "roller",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "Radius of the roller, for drawings.",
            },
            sim_kernel::Quantity {
                name: "g",
                unit: "m/s^2",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
        ],
        inputs: &[],
        constraints: &[
            sim_kernel::Quantity {
                name: "drive",
                unit: "N*m",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "contact",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
        ],
        speed_constraints: &[],
        norm_constraints: &[],
        sparsity: &[],
        conditionals: &[],
        events: &[
            sim_kernel::event::Event {
                name: "period",
                direction: sim_kernel::event::Direction::Both,
                on_forces: false,
                steps: &[],
            },
            sim_kernel::event::Event {
                name: "float",
                direction: sim_kernel::event::Direction::Falling,
                on_forces: true,
                steps: &[],
            },
        ],
        outputs: &[
            sim_kernel::Quantity {
                name: "s",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "lift",
            },
            sim_kernel::Quantity {
                name: "a",
                unit: "m/s^2",
                factor: 1f64,
                is_length: false,
                docs: "acceleration",
            },
            sim_kernel::Quantity {
                name: "N",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "contact",
            },
            sim_kernel::Quantity {
                name: "T",
                unit: "N*m",
                factor: 1f64,
                is_length: false,
                docs: "drive",
            },
        ],
        rated_outputs: &[0],
        figures: &[
            sim_kernel::Figure {
                name: "follower_lift",
                title: "Lift of the follower",
                len: 1,
            },
            sim_kernel::Figure {
                name: "follower_acceleration",
                title: "Acceleration of the follower",
                len: 1,
            },
            sim_kernel::Figure {
                name: "contact_force",
                title: "Force of the cam on the follower",
                len: 1,
            },
            sim_kernel::Figure {
                name: "torque",
                title: "Torque of the drive",
                len: 1,
            },
        ],
        optional_kernels: &["dynamics_jacobian"],
        dimension: 2,
        drawing: &[
            sim_kernel::Shape::Ground(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Circle,
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Slider,
            sim_kernel::Shape::Spring,
            sim_kernel::Shape::Points(1),
        ],
    };
    fn defaults() -> Self {
        Self {
            w: S::from_f64(31.41592653589793f64),
            r: S::from_f64(0.04f64),
            J: S::from_f64(0.002f64),
            m: S::from_f64(0.6f64),
            k: S::from_f64(2000f64),
            F0: S::from_f64(60f64),
            roller: S::from_f64(0.01f64),
            g: S::from_f64(9.81f64),
        }
    }
    fn parameters(&self) -> [S; 8] {
        [self.w, self.r, self.J, self.m, self.k, self.F0, self.roller, self.g]
    }
    fn with_parameters(&self, parameters: [S; 8]) -> Self {
        Self {
            w: parameters[0],
            r: parameters[1],
            J: parameters[2],
            m: parameters[3],
            k: parameters[4],
            F0: parameters[5],
            roller: parameters[6],
            g: parameters[7],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> CamFollower<T> {
        CamFollower {
            w: convert(self.w),
            r: convert(self.r),
            J: convert(self.J),
            m: convert(self.m),
            k: convert(self.k),
            F0: convert(self.F0),
            roller: convert(self.roller),
            g: convert(self.g),
        }
    }
    fn inputs(&self) -> [sim_kernel::Input<S>; 0] {
        []
    }
    fn with_inputs(&self, inputs: [sim_kernel::Input<S>; 0]) -> Self {
        Self { ..*self }
    }
    fn set_inputs(prepared: &mut Self::Prepared, inputs: [sim_kernel::Input<S>; 0]) {}
    #[inline(always)]
    fn prepare(&self) -> CamFollowerPrepared<S> {
        self.prepare()
    }
    #[inline(always)]
    fn prepared_dynamics(
        prepared: &Self::Prepared,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::Dynamics<S, [S; 2], [S; 2]> {
        prepared.dynamics(t, q, qd)
    }
    #[inline(always)]
    fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 2]; 2], [[S; 2]; 2]> {
        self.prepare().dynamics_jacobian(t, q, qd)
    }
    #[inline(always)]
    fn mass_matrix(&self, t: S, q: &[S; 2]) -> [[S; 2]; 2] {
        self.mass_matrix(t, q)
    }
    #[inline(always)]
    fn convective_forces(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 2] {
        self.convective_forces(t, q, qd)
    }
    #[inline(always)]
    fn generalized_forces(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 2] {
        self.generalized_forces(t, q, qd)
    }
    #[inline(always)]
    fn constraints(&self, t: S, q: &[S; 2]) -> [S; 2] {
        self.constraints(t, q)
    }
    #[inline(always)]
    fn constraint_magnitudes(&self, t: S, q: &[S; 2]) -> [S; 2] {
        self.constraint_magnitudes(t, q)
    }
    #[inline(always)]
    fn constraint_jacobian(&self, t: S, q: &[S; 2]) -> [[S; 2]; 2] {
        self.constraint_jacobian(t, q)
    }
    #[inline(always)]
    fn constraint_time_derivative(&self, t: S, q: &[S; 2]) -> [S; 2] {
        self.constraint_time_derivative(t, q)
    }
    #[inline(always)]
    fn constraint_convective(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 2] {
        self.constraint_convective(t, q, qd)
    }
    #[inline(always)]
    fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 2],
    ) -> sim_kernel::ConstraintLinearization<[S; 2], [[S; 2]; 2]> {
        self.constraint_linearization(t, q)
    }
    #[inline(always)]
    fn kinetic_energy(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> S {
        self.kinetic_energy(t, q, qd)
    }
    #[inline(always)]
    fn power(&self, t: S, q: &[S; 2], qd: &[S; 2], qdd: &[S; 2], lambda: &[S; 2]) -> S {
        self.power(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn outputs(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 2],
    ) -> [S; 4] {
        self.outputs(t, q, qd, qdd, lambda).into()
    }
    #[inline(always)]
    fn output_rates(&self, t: S, q: &[S; 2], qd: &[S; 2], qdd: &[S; 2]) -> [S; 1] {
        self.output_rates(t, q, qd, qdd).into()
    }
    #[inline(always)]
    fn events(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 2],
    ) -> [S; 2] {
        self.events(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn drawing(&self, t: S, q: &[S; 2]) -> [S; 168] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 2]> {
        self.initial()
    }
}
