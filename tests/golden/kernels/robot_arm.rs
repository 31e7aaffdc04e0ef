/// A six-axis arm with a spherical wrist, let swing from rest under the torques of its drives.
///
/// The fields are its parameters and inputs, in SI units; the methods are its kernels.
///
/// # Equations of motion
///
/// ```text
/// mass_matrix * accelerations = generalized_forces - convective_forces
/// coordinates = [q1; q2; q3; q4; q5; q6]
/// [
///     mass_matrix[1, 1], mass_matrix[1, 2], mass_matrix[1, 3], mass_matrix[1, 4], mass_matrix[1, 5], mass_matrix[1, 6];
///     mass_matrix[1, 2], mass_matrix[2, 2], mass_matrix[2, 3], mass_matrix[2, 4], mass_matrix[2, 5], mass_matrix[2, 6];
///     mass_matrix[1, 3], mass_matrix[2, 3], mass_matrix[3, 3], mass_matrix[3, 4], mass_matrix[3, 5], mass_matrix[2, 6];
///     mass_matrix[1, 4], mass_matrix[2, 4], mass_matrix[3, 4], mass_matrix[4, 4], 0, 0.002*cos(q5);
///     mass_matrix[1, 5], mass_matrix[2, 5], mass_matrix[3, 5], 0, mass_matrix[5, 5], 0;
///     mass_matrix[1, 6], mass_matrix[2, 6], mass_matrix[2, 6], 0.002*cos(q5), 0, 0.002
/// ] * [
///     q1_ddot;
///     q2_ddot;
///     q3_ddot;
///     q4_ddot;
///     q5_ddot;
///     q6_ddot
/// ] = [
///     generalized_forces[1] - convective_forces[1];
///     generalized_forces[2] - convective_forces[2];
///     generalized_forces[3] - convective_forces[3];
///     generalized_forces[4] - convective_forces[4];
///     generalized_forces[5] - convective_forces[5];
///     tau6 - 0.025*c*q6_dot - convective_forces[6]
/// ]
///
/// mass_matrix = [
///     mass_matrix[1, 1], mass_matrix[1, 2], mass_matrix[1, 3], mass_matrix[1, 4], mass_matrix[1, 5], mass_matrix[1, 6];
///     mass_matrix[1, 2], mass_matrix[2, 2], mass_matrix[2, 3], mass_matrix[2, 4], mass_matrix[2, 5], mass_matrix[2, 6];
///     mass_matrix[1, 3], mass_matrix[2, 3], mass_matrix[3, 3], mass_matrix[3, 4], mass_matrix[3, 5], mass_matrix[2, 6];
///     mass_matrix[1, 4], mass_matrix[2, 4], mass_matrix[3, 4], mass_matrix[4, 4], 0, 0.002*cos(q5);
///     mass_matrix[1, 5], mass_matrix[2, 5], mass_matrix[3, 5], 0, mass_matrix[5, 5], 0;
///     mass_matrix[1, 6], mass_matrix[2, 6], mass_matrix[2, 6], 0.002*cos(q5), 0, 0.002
/// ]
/// mass_matrix[1, 1] = m5*s_32^2*sin(q4)^2*sin(q5)^2 + m6*s_32^2*sin(q4)^2*sin(q5)^2 + m6*s_50^2 + m6*s_92^2
///     + 0.16*a1^2*m1 + 0.65*sin(q2)^2 + 0.0025*m2*s_68^2 + 0.1*s_6^2 + 0.3*s_3^2
///     + 0.0001*m3*s_71^2 + 0.006*s_3^2*sin(q4)^2 + 0.01*m4*s_74^2 + 0.01*m4*s_76^2
///     + 0.007*s_14^2 + 0.007*s_10^2 + 0.04*m5*s_81^2 + 0.04*m5*s_84^2 + 0.0015*s_15^2
///     + 0.0015*s_16^2 + 0.8
/// mass_matrix[1, 2] = m5*s_32*s_40*sin(q4)*sin(q5) + m6*s_32*s_40*sin(q4)*sin(q5) + 0.006*s_3*sin(q4)*cos(q4)
///     - 0.01*m4*s_74*s_75 + 0.01*m4*s_76*s_77 - 0.007*s_14*sin(q4)*sin(q5)
///     - 0.007*s_10*sin(q4)*cos(q5) - 0.04*m5*s_81*s_82 - 0.04*m5*s_84*s_85 + 0.0015*s_15*s_44
///     - 0.0015*s_16*s_89 - m6*s_50*s_90 - m6*s_55*s_92
/// mass_matrix[1, 3] = d4*m5*s_32*sin(q4)*cos(q4)*sin(q5)^2 + d4*m6*s_32*sin(q4)*cos(q4)*sin(q5)^2
///     + 0.006*s_3*sin(q4)*cos(q4) - 0.007*s_14*sin(q4)*sin(q5) - 0.007*s_10*sin(q4)*cos(q5)
///     + 0.0015*s_15*s_44 - 0.0015*s_16*s_89 + 0.07*d4*m4*s_74*sin(q4) - 0.07*d4*m4*s_76*cos(q4)
///     - 0.04*m5*s_81*s_83 + 0.04*m5*s_84*s_86 - m6*s_50*s_91 - m6*s_56*s_92
/// mass_matrix[1, 4] = d6*m6*s_50*sin(q5)*cos(q6) - 0.02*sin(q2)*cos(q3) - 0.02*cos(q2)*sin(q3)
///     + d6*m6*s_92*sin(q5)*sin(q6) - 0.007*s_14*cos(q5) + 0.007*s_10*sin(q5)
///     + 0.04*d6*m5*s_81*sin(q5) + 0.0015*s_15*sin(q5)*sin(q6) + 0.0015*s_16*sin(q5)*cos(q6)
/// mass_matrix[1, 5] = 0.006*s_3*sin(q4) + d6*m6*s_92*cos(q6) + 0.04*d6*m5*s_84 + 0.0015*s_15*cos(q6)
///     - 0.0015*s_16*sin(q6) - d6*m6*s_50*sin(q6)
/// mass_matrix[1, 6] = -0.002*s_6*cos(q5) - 0.002*s_3*cos(q4)*sin(q5)
/// mass_matrix[2, 2] = a2^2*m4*cos(q3)^2 + m5*s_40^2 + m6*s_40^2 + m6*s_90^2 + m6*s_55^2 + 0.2025*a2^2*m2
///     + 0.0001*m3*(100*a2*cos(q3) + 3)^2 + 0.04*m3*(d4 - 5*a2*sin(q3))^2 + 0.001*sin(q4)^2
///     + 0.01*m4*s_75^2 + 0.01*m4*s_77^2 + 0.04*m5*s_82^2 + 0.04*m5*s_85^2 + 0.0015*s_44^2
///     + 0.0015*s_89^2 + 1.116
/// mass_matrix[2, 3] = d4*m5*s_40*cos(q4)*sin(q5) + d4*m6*s_40*cos(q4)*sin(q5) + m6*s_90*s_91 + m6*s_55*s_56
///     + 0.001*sin(q4)^2 + 0.0015*s_44^2 + 0.0015*s_89^2 + 0.0003*m3*(100*a2*cos(q3) + 3)
///     + 0.04*d4*m3*(d4 - 5*a2*sin(q3)) - 0.07*d4*m4*s_75*sin(q4) - 0.07*d4*m4*s_77*cos(q4)
///     + 0.04*m5*s_82*s_83 - 0.04*m5*s_85*s_86 + 0.316
/// mass_matrix[2, 4] = 0.0015*s_44*sin(q5)*sin(q6) - 0.04*d6*m5*s_82*sin(q5) - 0.0015*s_89*sin(q5)*cos(q6)
///     - d6*m6*s_90*sin(q5)*cos(q6) - d6*m6*s_55*sin(q5)*sin(q6)
/// mass_matrix[2, 5] = 0.006*cos(q4) + d6*m6*s_90*sin(q6) - 0.04*d6*m5*s_85 + 0.0015*s_44*cos(q6)
///     + 0.0015*s_89*sin(q6) - d6*m6*s_55*cos(q6)
/// mass_matrix[2, 6] = 0.002*sin(q4)*sin(q5)
/// mass_matrix[3, 3] = 0.0009*m3 + d4^2*m5*cos(q4)^2*sin(q5)^2 + d4^2*m6*cos(q4)^2*sin(q5)^2 + m6*s_91^2
///     + m6*s_56^2 + 0.001*sin(q4)^2 + 0.0015*s_44^2 + 0.0015*s_89^2 + 0.04*d4^2*m3
///     + 0.04*m5*s_83^2 + 0.04*m5*s_86^2 + 0.49*d4^2*m4 + 0.316
/// mass_matrix[3, 4] = 0.0015*s_44*sin(q5)*sin(q6) - 0.0015*s_89*sin(q5)*cos(q6) - 0.04*d6*m5*s_83*sin(q5)
///     - d6*m6*s_91*sin(q5)*cos(q6) - d6*m6*s_56*sin(q5)*sin(q6)
/// mass_matrix[3, 5] = 0.006*cos(q4) + d6*m6*s_91*sin(q6) + 0.0015*s_44*cos(q6) + 0.0015*s_89*sin(q6)
///     + 0.04*d6*m5*s_86 - d6*m6*s_56*cos(q6)
/// mass_matrix[4, 4] = 0.0015*sin(q5)^2 + 0.04*d6^2*m5*sin(q5)^2 + d6^2*m6*sin(q5)^2 + 0.027
/// mass_matrix[5, 5] = 0.04*d6^2*m5 + d6^2*m6 + 0.0075
///
/// convective_forces = [
///     convective_forces[1];
///     convective_forces[2];
///     convective_forces[3];
///     convective_forces[4];
///     convective_forces[5];
///     convective_forces[6]
/// ]
/// convective_forces[1] = m6*s_47*s_50 + m6*s_67*s_92 + 1.3*q1_dot*q2_dot*sin(q2)*cos(q2)
///     + 0.045*a2*m2*s_68*q1_dot*q2_dot*cos(q2) + 0.01*s_6*s_69 - 0.01*s_3*s_70
///     + 0.0001*m3*s_28*s_71 + 0.02*s_6*s_34 + 0.02*s_3*s_72*sin(q4) - 0.02*s_3*s_73*cos(q4)
///     - 0.01*m4*s_60*s_74 + 0.01*m4*s_61*s_76 + 0.001*s_14*s_78 + 0.002*s_3*s_79*sin(q4)
///     + 0.001*s_10*s_80 - 0.2*m5*s_32*s_63*sin(q4)*sin(q5) + 0.04*m5*s_64*s_81
///     + 0.04*m5*s_65*s_84 + 0.002*s_14*s_62 + 0.0005*s_15*s_87 - 0.0005*s_16*s_88
///     - m6*s_32*s_66*sin(q4)*sin(q5)
/// convective_forces[2] = 0.16*s_1*s_2 - 0.65*q1_dot^2*sin(q2)*cos(q2)
///     - 0.0225*a2*m2*(20*a1*q1_dot^2*cos(q2) + 9*a2*q1_dot^2*sin(q2)*cos(q2))
///     - 0.0001*m3*s_57*(100*a2*cos(q3) + 3) + 0.002*m3*s_58*(d4 - 5*a2*sin(q3))
///     + 0.02*s_72*cos(q4) + 0.02*s_73*sin(q4) - 0.1*a2*m4*s_59*cos(q3) + 0.01*m4*s_60*s_75
///     + 0.01*m4*s_61*s_77 - 0.001*s_78*sin(q4)*sin(q5) + 0.002*s_79*cos(q4)
///     - 0.001*s_80*sin(q4)*cos(q5) - 0.2*m5*s_40*s_63 - 0.04*m5*s_64*s_82 - 0.04*m5*s_65*s_85
///     - 0.002*s_62*sin(q4)*sin(q5) + 0.0005*s_44*s_87 + 0.0005*s_88*s_89 - m6*s_40*s_66
///     - m6*s_47*s_90 - m6*s_55*s_67
/// convective_forces[3] = 0.16*s_1*s_2 + 0.02*s_72*cos(q4) + 0.02*s_73*sin(q4) - 0.001*s_78*sin(q4)*sin(q5)
///     + 0.002*s_79*cos(q4) - 0.001*s_80*sin(q4)*cos(q5) - 0.002*s_62*sin(q4)*sin(q5)
///     + 0.0005*s_44*s_87 + 0.0005*s_88*s_89 - 0.0003*m3*s_57 + 0.002*d4*m3*s_58
///     - 0.07*d4*m4*s_60*sin(q4) - 0.07*d4*m4*s_61*cos(q4) - 0.2*d4*m5*s_63*cos(q4)*sin(q5)
///     - 0.04*m5*s_64*s_83 + 0.04*m5*s_65*s_86 - d4*m6*s_66*cos(q4)*sin(q5) - m6*s_47*s_91
///     - m6*s_56*s_67
/// convective_forces[4] = 0.02*q1_dot*q2_dot*sin(q2)*sin(q3) - 0.02*s_1*q3_dot
///     - 0.02*q1_dot*q2_dot*cos(q2)*cos(q3) + d6*m6*s_47*sin(q5)*cos(q6)
///     + d6*m6*s_67*sin(q5)*sin(q6) - 0.001*s_78*cos(q5) + 0.001*s_80*sin(q5)
///     + 0.04*d6*m5*s_64*sin(q5) - 0.002*s_62*cos(q5) + 0.0005*s_87*sin(q5)*sin(q6)
///     - 0.0005*s_88*sin(q5)*cos(q6)
/// convective_forces[5] = 0.006*s_5*q4_dot - 0.002*s_8*s_9 - 0.006*s_29*sin(q4) + d6*m6*s_67*cos(q6)
///     + 0.04*d6*m5*s_65 + 0.0005*s_87*cos(q6) + 0.0005*s_88*sin(q6) - d6*m6*s_47*sin(q6)
/// convective_forces[6] = 0.002*s_35 - 0.002*s_9*q5_dot - 0.002*s_34*cos(q5)
///
/// generalized_forces = [
///     generalized_forces[1];
///     generalized_forces[2];
///     generalized_forces[3];
///     generalized_forces[4];
///     generalized_forces[5];
///     tau6 - 0.025*c*q6_dot
/// ]
/// generalized_forces[1] = tau1 - c*q1_dot + m5*s_22*s_32*sin(q4)*sin(q5) + m6*s_22*s_32*sin(q4)*sin(q5)
///     + m6*s_24*s_50 - 0.1*m4*s_21*s_74*sin(q4) + 0.1*m4*s_21*s_76*cos(q4)
///     + 0.2*m5*s_21*s_81*sin(q4) - 0.2*m5*s_23*s_84 - m6*s_25*s_92
/// generalized_forces[2] = tau2 - c*q2_dot + a2*m4*s_20*cos(q3) + m5*s_22*s_40 + m6*s_22*s_40 + m6*s_25*s_55
///     + 0.45*a2*m2*g*sin(q2) + 0.01*m3*s_20*(100*a2*cos(q3) + 3)
///     - 0.2*m3*s_21*(d4 - 5*a2*sin(q3)) + 0.1*m4*s_21*s_75*sin(q4) + 0.1*m4*s_21*s_77*cos(q4)
///     - 0.2*m5*s_21*s_82*sin(q4) + 0.2*m5*s_23*s_85 - m6*s_24*s_90
/// generalized_forces[3] = tau3 - c*q3_dot + 0.03*m3*s_20 + d4*m5*s_22*cos(q4)*sin(q5)
///     + d4*m6*s_22*cos(q4)*sin(q5) + m6*s_25*s_56 - 0.2*d4*m3*s_21 - 0.2*m5*s_21*s_83*sin(q4)
///     - 0.2*m5*s_23*s_86 - m6*s_24*s_91 - 0.7*d4*m4*s_21
/// generalized_forces[4] = tau4 - 0.025*c*q4_dot + d6*m6*s_24*sin(q5)*cos(q6) + 0.2*d6*m5*s_21*sin(q4)*sin(q5)
///     - d6*m6*s_25*sin(q5)*sin(q6)
/// generalized_forces[5] = tau5 - 0.025*c*q5_dot - 0.2*d6*m5*s_23 - d6*m6*s_24*sin(q6) - d6*m6*s_25*cos(q6)
///
/// s_1 = q1_dot*cos(q2)*cos(q3) - q1_dot*sin(q2)*sin(q3)
/// s_2 = q1_dot*sin(q2)*cos(q3) + q1_dot*cos(q2)*sin(q3)
/// s_3 = cos(q2)*cos(q3) - sin(q2)*sin(q3)
/// s_4 = (q2_dot + q3_dot)*cos(q4) + s_1*sin(q4)
/// s_5 = s_1*cos(q4) - (q2_dot + q3_dot)*sin(q4)
/// s_6 = sin(q2)*cos(q3) + cos(q2)*sin(q3)
/// s_7 = q4_dot - q1_dot*sin(q2)*cos(q3) - q1_dot*cos(q2)*sin(q3)
/// s_8 = s_7*cos(q5) - s_5*sin(q5)
/// s_9 = s_7*sin(q5) + s_5*cos(q5)
/// s_10 = s_3*cos(q4)*cos(q5) - s_6*sin(q5)
/// s_11 = q5_dot + (q2_dot + q3_dot)*cos(q4) + s_1*sin(q4)
/// s_12 = s_11*cos(q6) + s_9*sin(q6)
/// s_13 = s_9*cos(q6) - s_11*sin(q6)
/// s_14 = s_6*cos(q5) + s_3*cos(q4)*sin(q5)
/// s_15 = s_3*sin(q4)*cos(q6) + s_10*sin(q6)
/// s_16 = s_10*cos(q6) - s_3*sin(q4)*sin(q6)
/// s_17 = q6_dot + s_7*cos(q5) - s_5*sin(q5)
/// s_18 = d4*((q2_dot + q3_dot)^2 + s_1^2)
/// s_19 = a2*(q2_dot^2 + q1_dot^2*sin(q2)^2) + a1*q1_dot^2*sin(q2)
/// s_20 = g*sin(q2)*cos(q3) + g*cos(q2)*sin(q3)
/// s_21 = g*sin(q2)*sin(q3) - g*cos(q2)*cos(q3)
/// s_22 = s_20*cos(q5) - s_21*cos(q4)*sin(q5)
/// s_23 = s_20*sin(q5) + s_21*cos(q4)*cos(q5)
/// s_24 = s_21*sin(q4)*cos(q6) + s_23*sin(q6)
/// s_25 = s_23*cos(q6) - s_21*sin(q4)*sin(q6)
/// s_26 = a1*q1_dot^2*cos(q2) + a2*q1_dot^2*sin(q2)*cos(q2)
/// s_27 = s_2*q3_dot + s_2*(q2_dot + q3_dot) + q1_dot*q2_dot*cos(q2)*sin(q3)
///     + q1_dot*q2_dot*sin(q2)*cos(q3)
/// s_28 = 3*s_1*q3_dot + 3*s_1*(q2_dot + q3_dot) + 200*a2*q1_dot*q2_dot*cos(q2)
///     - 3*q1_dot*q2_dot*sin(q2)*sin(q3) + 3*q1_dot*q2_dot*cos(q2)*cos(q3) - 20*d4*s_27
/// s_29 = s_2*q3_dot + q1_dot*q2_dot*cos(q2)*sin(q3) + q1_dot*q2_dot*sin(q2)*cos(q3)
/// s_30 = 2*a2*q1_dot*q2_dot*cos(q2) - d4*s_27
/// s_31 = s_19*cos(q3) + d4*s_1*s_2 + s_26*sin(q3)
/// s_32 = a1 + a2*sin(q2) + d4*s_3
/// s_33 = (d4 - a2*sin(q3))*sin(q4)
/// s_34 = s_1*q3_dot - q1_dot*q2_dot*sin(q2)*sin(q3) + q1_dot*q2_dot*cos(q2)*cos(q3)
/// s_35 = (s_4*q4_dot + s_29*cos(q4))*sin(q5)
/// s_36 = (s_4*q4_dot + s_29*cos(q4))*cos(q5)
/// s_37 = s_8*q5_dot - s_34*sin(q5) - s_36
/// s_38 = s_18 - s_19*sin(q3) + s_26*cos(q3)
/// s_39 = s_30*sin(q4) + s_31*cos(q4)
/// s_40 = a2*cos(q3)*cos(q5) + (d4 - a2*sin(q3))*cos(q4)*sin(q5)
/// s_41 = d6*(s_8*q5_dot + s_8*s_11 - s_34*sin(q5) - s_36)
/// s_42 = d6*(s_5*q4_dot - s_8*s_9 - s_29*sin(q4))
/// s_43 = (d4 - a2*sin(q3))*cos(q4)*cos(q5)
/// s_44 = cos(q4)*cos(q6) - sin(q4)*cos(q5)*sin(q6)
/// s_45 = s_30*cos(q4) - s_31*sin(q4) + s_41
/// s_46 = s_42 + s_38*sin(q5) + s_39*cos(q5)
/// s_47 = s_45*cos(q6) - s_46*sin(q6)
/// s_48 = s_32*cos(q4) + d6*s_10
/// s_49 = d6*s_3*sin(q4) + s_32*sin(q4)*cos(q5)
/// s_50 = s_48*cos(q6) - s_49*sin(q6)
/// s_51 = s_33 + d6*sin(q4)*cos(q5)
/// s_52 = a2*cos(q3)*sin(q5) - d6*cos(q4) - s_43
/// s_53 = d4*sin(q4) + d6*sin(q4)*cos(q5)
/// s_54 = d6*cos(q4) + d4*cos(q4)*cos(q5)
/// s_55 = s_51*sin(q6) + s_52*cos(q6)
/// s_56 = s_53*sin(q6) - s_54*cos(q6)
/// s_57 = 3*s_1*s_2 + 20*s_18 - 100*s_19*sin(q3) + 100*s_26*cos(q3)
/// s_58 = 3*(q2_dot + q3_dot)^2 + 3*s_2^2 + 100*s_19*cos(q3) + 20*d4*s_1*s_2 + 100*s_26*sin(q3)
/// s_59 = 10*s_18 - 10*s_19*sin(q3) - 3*d4*(s_4^2 + s_5^2) + 10*s_26*cos(q3)
/// s_60 = 3*d4*(s_4*q4_dot - s_4*s_7 + s_29*cos(q4)) + 10*s_30*cos(q4) - 10*s_31*sin(q4)
/// s_61 = 3*d4*(s_5*q4_dot - s_5*s_7 - s_29*sin(q4)) - 10*s_30*sin(q4) - 10*s_31*cos(q4)
/// s_62 = s_9*q5_dot + s_34*cos(q5) - s_35
/// s_63 = d6*(s_11^2 + s_9^2) - 5*s_39*sin(q5) + 5*s_38*cos(q5)
/// s_64 = 5*s_30*cos(q4) - 5*s_31*sin(q4) + s_41
/// s_65 = s_42 + 5*s_38*sin(q5) + 5*s_39*cos(q5)
/// s_66 = d6*(s_11^2 + s_9^2) - s_39*sin(q5) + s_38*cos(q5)
/// s_67 = s_45*sin(q6) + s_46*cos(q6)
/// s_68 = 20*a1 + 9*a2*sin(q2)
/// s_69 = 8*s_1*q3_dot + s_1*(q2_dot + q3_dot) - 8*q1_dot*q2_dot*sin(q2)*sin(q3)
///     + 8*q1_dot*q2_dot*cos(q2)*cos(q3)
/// s_70 = 24*s_2*q3_dot + 17*s_2*(q2_dot + q3_dot) + 24*q1_dot*q2_dot*cos(q2)*sin(q3)
///     + 24*q1_dot*q2_dot*sin(q2)*cos(q3)
/// s_71 = 100*a1 + 3*sin(q2)*cos(q3) + 3*cos(q2)*sin(q3) + 100*a2*sin(q2) + 20*d4*s_3
/// s_72 = 3*s_5*q4_dot - 2*s_5*s_7 - 3*s_29*sin(q4)
/// s_73 = 3*s_4*q4_dot - 2*s_4*s_7 + 3*s_29*cos(q4)
/// s_74 = 3*d4*s_3*cos(q4) - 10*s_32*cos(q4)
/// s_75 = 3*d4*sin(q4) - 10*s_33
/// s_76 = 3*d4*s_3*sin(q4) - 10*s_32*sin(q4)
/// s_77 = 3*d4*cos(q4) - 10*(d4 - a2*sin(q3))*cos(q4)
/// s_78 = 5*s_9*q5_dot - s_9*s_11 + 5*s_34*cos(q5) - 5*s_35
/// s_79 = 3*s_5*q4_dot - s_8*s_9 - 3*s_29*sin(q4)
/// s_80 = 7*s_8*q5_dot + s_8*s_11 - 7*s_34*sin(q5) - 7*s_36
/// s_81 = 5*s_32*cos(q4) + d6*s_10
/// s_82 = 5*s_33 + d6*sin(q4)*cos(q5)
/// s_83 = 5*d4*sin(q4) + d6*sin(q4)*cos(q5)
/// s_84 = d6*s_3*sin(q4) + 5*s_32*sin(q4)*cos(q5)
/// s_85 = 5*a2*cos(q3)*sin(q5) - d6*cos(q4) - 5*s_43
/// s_86 = d6*cos(q4) + 5*d4*cos(q4)*cos(q5)
/// s_87 = 3*s_13*q6_dot + s_13*s_17 + 3*(s_5*q4_dot - s_29*sin(q4))*cos(q6) + 3*s_37*sin(q6)
/// s_88 = 3*s_12*q6_dot + s_12*s_17 - 3*s_37*cos(q6) + 3*(s_5*q4_dot - s_29*sin(q4))*sin(q6)
/// s_89 = sin(q4)*cos(q5)*cos(q6) + cos(q4)*sin(q6)
/// s_90 = s_51*cos(q6) - s_52*sin(q6)
/// s_91 = s_53*cos(q6) + s_54*sin(q6)
/// s_92 = s_48*sin(q6) + s_49*cos(q6)
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RobotArm<S = ::core::primitive::f64> {
    /// Height of the shoulder over the base, in `m`.
    pub h: S,
    /// Shoulder ahead of the waist's axis, in `m`.
    pub a1: S,
    /// Length of the upper arm, in `m`.
    pub a2: S,
    /// Elbow to wrist, in `m`.
    pub d4: S,
    /// Wrist to flange, in `m`.
    pub d6: S,
    /// In `kg`.
    pub m1: S,
    /// In `kg`.
    pub m2: S,
    /// In `kg`.
    pub m3: S,
    /// In `kg`.
    pub m4: S,
    /// In `kg`.
    pub m5: S,
    /// In `kg`.
    pub m6: S,
    /// In `m/s^2`.
    pub g: S,
    /// Viscous friction of the first three drives; those of the wrist have a fortieth of it, in `N*m*s`.
    pub c: S,
    /// In `N*m`.
    pub tau1: sim_kernel::Input<S>,
    /// In `N*m`.
    pub tau2: sim_kernel::Input<S>,
    /// In `N*m`.
    pub tau3: sim_kernel::Input<S>,
    /// In `N*m`.
    pub tau4: sim_kernel::Input<S>,
    /// In `N*m`.
    pub tau5: sim_kernel::Input<S>,
    /// In `N*m`.
    pub tau6: sim_kernel::Input<S>,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for RobotArm<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Mechanism<S>>::defaults()
    }
}
/// Coordinates of [`RobotArm`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RobotArmCoordinates<S = ::core::primitive::f64> {
    /// Waist, about the vertical, in `rad`.
    pub q1: S,
    /// Shoulder, in `rad`.
    pub q2: S,
    /// Elbow, in `rad`.
    pub q3: S,
    /// Roll of the forearm, in `rad`.
    pub q4: S,
    /// Bend of the wrist, in `rad`.
    pub q5: S,
    /// Turn of the flange, in `rad`.
    pub q6: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 6]> for RobotArmCoordinates<S> {
    fn from(values: [S; 6]) -> Self {
        Self {
            q1: values[0],
            q2: values[1],
            q3: values[2],
            q4: values[3],
            q5: values[4],
            q6: values[5],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<RobotArmCoordinates<S>> for [S; 6] {
    fn from(record: RobotArmCoordinates<S>) -> Self {
        [record.q1, record.q2, record.q3, record.q4, record.q5, record.q6]
    }
}
/// Outputs of [`RobotArm`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RobotArmOutputs<S = ::core::primitive::f64> {
    /// In `m`.
    pub x: S,
    /// In `m`.
    pub y: S,
    /// In `m`.
    pub height: S,
    /// speed of the flange, in `m/s`.
    pub flange_speed: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 4]> for RobotArmOutputs<S> {
    fn from(values: [S; 4]) -> Self {
        Self {
            x: values[0],
            y: values[1],
            height: values[2],
            flange_speed: values[3],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<RobotArmOutputs<S>> for [S; 4] {
    fn from(record: RobotArmOutputs<S>) -> Self {
        [record.x, record.y, record.height, record.flange_speed]
    }
}
/// Rates of the outputs of [`RobotArm`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RobotArmOutputRates<S = ::core::primitive::f64> {
    /// Rate of `x`.
    pub x: S,
    /// Rate of `y`.
    pub y: S,
    /// Rate of `height`.
    pub height: S,
    /// Rate of `flange_speed`.
    pub flange_speed: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 4]> for RobotArmOutputRates<S> {
    fn from(values: [S; 4]) -> Self {
        Self {
            x: values[0],
            y: values[1],
            height: values[2],
            flange_speed: values[3],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<RobotArmOutputRates<S>> for [S; 4] {
    fn from(record: RobotArmOutputRates<S>) -> Self {
        [record.x, record.y, record.height, record.flange_speed]
    }
}
/// What the equations of motion need of the parameters of [`RobotArm`], from [`RobotArm::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RobotArmPrepared<S = ::core::primitive::f64> {
    m5: S,
    a1: S,
    a2: S,
    d4: S,
    m6: S,
    d6: S,
    k: S,
    k_2: S,
    m3: S,
    k_3: S,
    k_4: S,
    k_5: S,
    m4: S,
    k_6: S,
    k_7: S,
    k_8: S,
    k_9: S,
    k_10: S,
    k_11: S,
    k_12: S,
    k_13: S,
    k_14: S,
    k_15: S,
    k_16: S,
    k_17: S,
    k_18: S,
    k_19: S,
    k_20: S,
    k_21: S,
    k_22: S,
    k_23: S,
    k_24: S,
    k_25: S,
    k_26: S,
    k_27: S,
    k_28: S,
    k_29: S,
    k_30: S,
    k_31: S,
    mass_q5_q5: S,
    c: S,
    k_32: S,
    k_33: S,
    g: S,
    k_34: S,
    k_35: S,
    k_36: S,
    k_37: S,
    k_38: S,
    k_39: S,
    k_40: S,
    k_41: S,
    k_42: S,
    k_43: S,
    inverse_q5: S,
    k_44: S,
    k_45: S,
    k_46: S,
    k_47: S,
    k_48: S,
    k_49: S,
    k_50: S,
    k_51: S,
    k_52: S,
    k_53: S,
    k_54: S,
    k_55: S,
    k_56: S,
    k_57: S,
    k_58: S,
    k_59: S,
    k_60: S,
    k_61: S,
    k_62: S,
    k_63: S,
    k_64: S,
    k_65: S,
    k_66: S,
    k_67: S,
    /// In `N*m`.
    pub tau1: sim_kernel::Input<S>,
    /// In `N*m`.
    pub tau2: sim_kernel::Input<S>,
    /// In `N*m`.
    pub tau3: sim_kernel::Input<S>,
    /// In `N*m`.
    pub tau4: sim_kernel::Input<S>,
    /// In `N*m`.
    pub tau5: sim_kernel::Input<S>,
    /// In `N*m`.
    pub tau6: sim_kernel::Input<S>,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> RobotArm<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 18 additions, 82 multiplications, 1 division.
    #[inline]
    pub fn prepare(&self) -> RobotArmPrepared<S> {
        let w = self.m5 * S::from_f64(0.04);
        let w_2 = S::from_f64(0.16) * self.a1 * self.a1 * self.m1;
        let a2_squared = self.a2 * self.a2;
        let w_3 = self.m3 * S::from_f64(0.04);
        let w_4 = self.d4 * self.m6;
        let w_5 = self.d4 * self.m4;
        let d4_squared = self.d4 * self.d4;
        let w_6 = self.m6 * self.d6;
        let d6_squared = self.d6 * self.d6;
        let w_7 = w * d6_squared;
        let w_8 = self.m6 * d6_squared;
        let w_9 = self.m5 * S::from_f64(0.2);
        let w_10 = self.d6 * w_9;
        let mass_q5_q5 = w_7 + w_8 + S::from_f64(0.0075);
        let w_11 = self.a2 * self.m2;
        let w_12 = self.a2 * self.m4;
        let w_13 = self.d4 * S::from_f64(0.002);
        RobotArmPrepared {
            m5: self.m5,
            a1: self.a1,
            a2: self.a2,
            d4: self.d4,
            m6: self.m6,
            d6: self.d6,
            k: self.a1 * S::from_f64(20.0),
            k_2: self.a2 * S::from_f64(9.0),
            m3: self.m3,
            k_3: self.a1 * S::from_f64(100.0),
            k_4: self.a2 * S::from_f64(100.0),
            k_5: self.d4 * S::from_f64(20.0),
            m4: self.m4,
            k_6: self.d4 * S::from_f64(3.0),
            k_7: S::from_f64(0.0025) * self.m2,
            k_8: S::from_f64(0.0001) * self.m3,
            k_9: S::from_f64(0.01) * self.m4,
            k_10: w,
            k_11: self.m5 + self.m6,
            k_12: w_2 + S::from_f64(0.8),
            k_13: self.a2 * S::from_f64(5.0),
            k_14: self.m4 * a2_squared,
            k_15: w_3,
            k_16: self.m2 * a2_squared * S::from_f64(0.2025) + S::from_f64(1.116),
            k_17: self.d4 * S::from_f64(5.0),
            k_18: w_4,
            k_19: S::from_f64(0.07) * w_5,
            k_20: self.m5 * self.d4 + w_4,
            k_21: self.m3 * S::from_f64(0.0003),
            k_22: self.d4 * w_3,
            k_23: self.m3 * S::from_f64(0.0009) + w_3 * d4_squared
                + self.m4 * d4_squared * S::from_f64(0.49) + S::from_f64(0.316),
            k_24: self.m5 * d4_squared + self.m6 * d4_squared,
            k_25: w_6,
            k_26: self.d6 * w,
            k_27: S::from_f64(0.0015) + w_7 + w_8,
            k_28: self.a1 * w_10 + self.a1 * w_6,
            k_29: self.a2 * w_10 + self.a2 * w_6,
            k_30: self.d4 * w_10 + self.d4 * w_6,
            k_31: S::from_f64(0.0075) + w_7 + w_8,
            mass_q5_q5: mass_q5_q5,
            c: self.c,
            k_32: self.a2 * S::from_f64(200.0),
            k_33: self.a2 * S::from_f64(2.0),
            g: self.g,
            k_34: S::from_f64(0.045) * w_11,
            k_35: w_9,
            k_36: S::from_f64(20.0) * self.g,
            k_37: self.d4 * S::from_f64(10.0),
            k_38: w_11 * S::from_f64(0.0225),
            k_39: self.m3 * S::from_f64(0.002),
            k_40: S::from_f64(0.1) * w_12,
            k_41: self.m3 * w_13,
            k_42: self.d4 * w_9,
            k_43: self.c * S::from_f64(0.025),
            inverse_q5: S::from_f64(1.0) / mass_q5_q5,
            k_44: w_12,
            k_45: self.g * w_11 * S::from_f64(0.45),
            k_46: self.m3 * S::from_f64(0.01),
            k_47: self.m3 * S::from_f64(0.2),
            k_48: S::from_f64(0.1) * self.m4,
            k_49: self.m6 * S::from_f64(10.0),
            k_50: self.m5 * S::from_f64(2.0),
            k_51: self.m4 * S::from_f64(10.0),
            k_52: self.m3 * S::from_f64(3.0),
            k_53: self.m6 * S::from_f64(5.0),
            k_54: self.m2 * S::from_f64(9.0),
            k_55: self.m3 * S::from_f64(4.0),
            k_56: self.m2 * S::from_f64(5.0),
            k_57: self.m6 * S::from_f64(25.0),
            k_58: self.d6 * S::from_f64(80.0),
            k_59: w_5 * S::from_f64(60.0),
            k_60: self.d4 * S::from_f64(4.0),
            k_61: self.a2 * S::from_f64(0.0025),
            k_62: self.a1 * S::from_f64(0.01),
            k_63: S::from_f64(0.7) + w_2,
            k_64: w_13,
            k_65: self.a2 * S::from_f64(0.2),
            k_66: self.a2 * S::from_f64(0.01),
            k_67: self.d6 * S::from_f64(0.04),
            tau1: self.tau1,
            tau2: self.tau2,
            tau3: self.tau3,
            tau4: self.tau4,
            tau5: self.tau5,
            tau6: self.tau6,
        }
    }
    /// Mass matrix `T_q' M T_q`, 6 x 6, symmetric, in SI units.
    ///
    /// Operations: 141 additions, 257 multiplications, 5 sine-cosine pairs.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 6]) -> [[S; 6]; 6] {
        let [_, q2, q3, q4, q5, q6] = *q;
        let (
            [sin_q4,
            sin_q5,
            sin_q2,
            sin_q3,
            sin_q6,
            ],
            [cos_q4,
            cos_q5,
            cos_q2,
            cos_q3,
            cos_q6,
            ],
        ) = S::sin_cos_each([q4, q5, q2, q3, q6]);
        let sin_q4_squared = sin_q4 * sin_q4;
        let sin_q5_squared = sin_q5 * sin_q5;
        let w = cos_q2 * cos_q3 - sin_q2 * sin_q3;
        let w_2 = self.a1 + self.a2 * sin_q2 + self.d4 * w;
        let w_3 = self.m5 + self.m6;
        let w_squared = w * w;
        let w_4 = sin_q4_squared
            * (sin_q5_squared * w_2 * w_2 * w_3 + w_squared * S::from_f64(0.006));
        let w_86 = sin_q4_squared * S::from_f64(0.001);
        let w_5 = w_2 * cos_q4;
        let w_6 = w * cos_q4;
        let w_7 = sin_q2 * cos_q3 + cos_q2 * sin_q3;
        let w_8 = cos_q5 * w_6 - sin_q5 * w_7;
        let w_9 = self.d6 * w_8;
        let w_10 = w_5 + w_9;
        let w_26 = w_9 + w_5 * S::from_f64(5.0);
        let w_11 = w * self.d6;
        let w_12 = w_2 * cos_q5;
        let w_13 = sin_q4 * (w_11 + w_12);
        let w_27 = sin_q4 * (w_11 + w_12 * S::from_f64(5.0));
        let w_14 = cos_q6 * w_10 - sin_q6 * w_13;
        let w_15 = w_10 * sin_q6 + cos_q6 * w_13;
        let w_16 = self.m6 * (w_14 * w_14 + w_15 * w_15);
        let w_17 = S::from_f64(0.01) * self.m4;
        let w_18 = self.d4 * S::from_f64(3.0);
        let w_19 = w * w_18 - w_2 * S::from_f64(10.0);
        let w_20 = cos_q4 * w_19;
        let w_21 = sin_q4 * w_19;
        let w_22 = w_17 * (w_20 * w_20 + w_21 * w_21);
        let w_23 = cos_q5 * w_7 + sin_q5 * w_6;
        let w_24 = S::from_f64(0.007) * (w_23 * w_23 + w_8 * w_8);
        let w_25 = self.m5 * S::from_f64(0.04);
        let w_28 = w_25 * (w_26 * w_26 + w_27 * w_27);
        let w_29 = sin_q4 * w;
        let w_30 = cos_q6 * w_29 + w_8 * sin_q6;
        let w_31 = cos_q6 * w_8 - sin_q6 * w_29;
        let w_39 = cos_q5 * w_8;
        let w_32 = S::from_f64(0.0015) * (w_30 * w_30 + w_31 * w_31);
        let w_33 = self.a1 * S::from_f64(20.0) + sin_q2 * self.a2 * S::from_f64(9.0);
        let w_34 = self.a2 * S::from_f64(100.0);
        let w_35 = self.a1 * S::from_f64(100.0) + w_7 * S::from_f64(3.0) + sin_q2 * w_34
            + w * self.d4 * S::from_f64(20.0);
        let w_83 = S::from_f64(3.0) + cos_q3 * w_34;
        let w_36 = S::from_f64(0.0001) * self.m3;
        let w_37 = self.d4 - self.a2 * sin_q3;
        let w_41 = w_18 - S::from_f64(10.0) * w_37;
        let w_38 = self.a2 * cos_q3 * cos_q5 + sin_q5 * cos_q4 * w_37;
        let w_40 = sin_q4
            * (sin_q5 * (w_2 * w_3 * w_38 - S::from_f64(0.007) * w_23)
                + w_6 * S::from_f64(0.006) - S::from_f64(0.007) * w_39);
        let w_42 = cos_q4 * w_41;
        let w_43 = sin_q4 * w_41;
        let w_44 = self.d6 * cos_q5;
        let w_45 = sin_q4 * (S::from_f64(5.0) * w_37 + w_44);
        let w_46 = self.a2 * S::from_f64(5.0);
        let w_47 = sin_q5 * cos_q3;
        let w_48 = cos_q5 * w_37;
        let w_54 = sin_q4 * (w_37 + w_44);
        let w_49 = w_46 * w_47 - cos_q4 * (self.d6 + S::from_f64(5.0) * w_48);
        let w_55 = self.a2 * w_47 - cos_q4 * (self.d6 + w_48);
        let w_84 = self.d4 - sin_q3 * w_46;
        let w_50 = sin_q4 * cos_q5;
        let w_51 = cos_q6 * cos_q4 - sin_q6 * w_50;
        let w_52 = cos_q6 * w_50 + cos_q4 * sin_q6;
        let w_53 = S::from_f64(0.0015) * (w_30 * w_51 - w_31 * w_52);
        let w_82 = S::from_f64(0.0015) * (w_51 * w_51 + w_52 * w_52);
        let w_56 = cos_q6 * w_54 - sin_q6 * w_55;
        let w_57 = sin_q6 * w_54 + cos_q6 * w_55;
        let mass_q2_q1 = w_40 + w_17 * (w_21 * w_42 - w_20 * w_43)
            - w_25 * (w_26 * w_45 + w_27 * w_49) + w_53
            - self.m6 * (w_14 * w_56 + w_15 * w_57);
        let w_80 = w_17 * (w_43 * w_43 + w_42 * w_42);
        let w_58 = self.m5 * self.d4 + self.d4 * self.m6;
        let w_59 = self.d4 * self.m4 * S::from_f64(0.07);
        let w_60 = sin_q4
            * (cos_q4 * (sin_q5_squared * w_2 * w_58 + w * S::from_f64(0.006))
                - S::from_f64(0.007) * (sin_q5 * w_23 + w_39) + w_20 * w_59);
        let mass_q6_q1 = -(w_23 * S::from_f64(0.002));
        let w_87 = cos_q4 * (sin_q5 * w_38 * w_58 - w_42 * w_59);
        let w_61 = self.d4 * S::from_f64(5.0);
        let w_62 = cos_q4 * (self.d6 + cos_q5 * w_61);
        let w_63 = sin_q4 * (w_44 + w_61);
        let w_64 = sin_q4 * (self.d4 + w_44);
        let w_65 = cos_q4 * (self.d6 + self.d4 * cos_q5);
        let w_66 = cos_q6 * w_64 + sin_q6 * w_65;
        let w_67 = sin_q6 * w_64 - cos_q6 * w_65;
        let mass_q3_q1 = w_53 + w_60 + w_25 * (w_27 * w_62 - w_26 * w_63)
            - self.m6 * (w_14 * w_66 + w_15 * w_67) - cos_q4 * w_21 * w_59;
        let w_68 = S::from_f64(0.2) * self.m5 * self.d6;
        let w_69 = self.m6 * self.d6;
        let w_70 = self.a1 * w_68 + self.a1 * w_69;
        let w_71 = self.d4 * w_68 + self.d4 * w_69;
        let w_76 = self.a2 * w_68 + self.a2 * w_69;
        let d6_squared = self.d6 * self.d6;
        let w_72 = w_25 * d6_squared;
        let w_73 = self.m6 * d6_squared;
        let w_74 = S::from_f64(0.0015) + w_72 + w_73;
        let w_75 = w_71 + cos_q5 * w_74;
        let mass_q4_q4 = S::from_f64(0.027) + sin_q5_squared * w_74;
        let w_77 = sin_q2 * w_76;
        let mass_q4_q1 = sin_q5 * cos_q4 * (w_70 + w * w_75 + w_77) - w_7 * mass_q4_q4;
        let w_78 = S::from_f64(0.0075) + w_72 + w_73;
        let mass_q5_q1 = sin_q4 * (cos_q5 * (w_70 + w_77 + w * w_71) + w * w_78);
        let a2_squared = self.a2 * self.a2;
        let w_79 = self.m6 * (w_56 * w_56 + w_57 * w_57);
        let w_81 = w_25 * (w_45 * w_45 + w_49 * w_49);
        let w_85 = self.m3 * S::from_f64(0.04);
        let mass_q3_q2 = w_82 + w_86 + S::from_f64(0.316) + w_87
            + self.m6 * (w_56 * w_66 + w_57 * w_67) + w_25 * (w_45 * w_63 - w_49 * w_62)
            + w_83 * self.m3 * S::from_f64(0.0003) + w_84 * self.d4 * w_85
            - sin_q4 * w_43 * w_59;
        let w_88 = sin_q3 * w_76;
        let mass_q5_q2 = cos_q4 * (w_78 + cos_q5 * (w_71 - w_88)) - w_47 * w_76;
        let mass_q4_q2 = sin_q4 * sin_q5 * (w_88 - w_75);
        let mass_q5_q3 = cos_q4 * (w_78 + cos_q5 * w_71);
        let w_89 = sin_q4 * sin_q5;
        let mass_q4_q3 = -(w_75 * w_89);
        let mass_q6_q2 = w_89 * S::from_f64(0.002);
        let d4_squared = self.d4 * self.d4;
        let w_90 = self.m3 * S::from_f64(0.0009) + w_85 * d4_squared
            + self.m4 * d4_squared * S::from_f64(0.49) + S::from_f64(0.316);
        let mass_q6_q4 = cos_q5 * S::from_f64(0.002);
        [
            [
                S::from_f64(0.16) * self.a1 * self.a1 * self.m1 + S::from_f64(0.8) + w_4
                    + w_16 + w_22 + w_24 + w_28 + w_32
                    + S::from_f64(0.65) * sin_q2 * sin_q2
                    + w_33 * w_33 * S::from_f64(0.0025) * self.m2
                    + S::from_f64(0.1) * w_7 * w_7 + S::from_f64(0.3) * w_squared
                    + w_35 * w_35 * w_36,
                mass_q2_q1,
                mass_q3_q1,
                mass_q4_q1,
                mass_q5_q1,
                mass_q6_q1,
            ],
            [
                mass_q2_q1,
                self.m2 * a2_squared * S::from_f64(0.2025) + S::from_f64(1.116) + w_79
                    + w_80 + w_81 + w_82 + cos_q3 * cos_q3 * self.m4 * a2_squared
                    + w_3 * w_38 * w_38 + w_36 * w_83 * w_83 + w_84 * w_84 * w_85 + w_86,
                mass_q3_q2,
                mass_q4_q2,
                mass_q5_q2,
                mass_q6_q2,
            ],
            [
                mass_q3_q1,
                mass_q3_q2,
                w_82 + w_86 + w_90 + self.m6 * (w_66 * w_66 + w_67 * w_67)
                    + w_25 * (w_63 * w_63 + w_62 * w_62)
                    + sin_q5_squared * cos_q4 * cos_q4
                        * (self.m5 * d4_squared + self.m6 * d4_squared),
                mass_q4_q3,
                mass_q5_q3,
                mass_q6_q2,
            ],
            [
                mass_q4_q1,
                mass_q4_q2,
                mass_q4_q3,
                mass_q4_q4,
                S::from_f64(0.0),
                mass_q6_q4,
            ],
            [
                mass_q5_q1,
                mass_q5_q2,
                mass_q5_q3,
                S::from_f64(0.0),
                w_72 + w_73 + S::from_f64(0.0075),
                S::from_f64(0.0),
            ],
            [
                mass_q6_q1,
                mass_q6_q2,
                mass_q6_q2,
                mass_q6_q4,
                S::from_f64(0.0),
                S::from_f64(0.002),
            ],
        ]
    }
    /// Convective forces `T_q' M g`, 6, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.
    ///
    /// Operations: 196 additions, 333 multiplications, 5 sine-cosine pairs.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 6], qd: &[S; 6]) -> [S; 6] {
        let [_, q2, q3, q4, q5, q6] = *q;
        let [q1_dot, q2_dot, q3_dot, q4_dot, q5_dot, q6_dot] = *qd;
        let (
            [sin_q6,
            sin_q4,
            sin_q2,
            sin_q3,
            sin_q5,
            ],
            [cos_q6,
            cos_q4,
            cos_q2,
            cos_q3,
            cos_q5,
            ],
        ) = S::sin_cos_each([q6, q4, q2, q3, q5]);
        let w = cos_q2 * cos_q3 - sin_q2 * sin_q3;
        let w_2 = q1_dot * w;
        let w_3 = q2_dot + q3_dot;
        let w_4 = cos_q4 * w_2 - w_3 * sin_q4;
        let w_5 = q4_dot * w_4;
        let w_6 = sin_q2 * cos_q3 + cos_q2 * sin_q3;
        let w_7 = q1_dot * q2_dot;
        let w_8 = w_6 * w_7;
        let w_9 = q1_dot * w_6;
        let w_10 = w_8 + q3_dot * w_9;
        let w_11 = sin_q4 * w_10;
        let w_12 = w_5 - w_11;
        let w_13 = S::from_f64(3.0) * w_12;
        let w_14 = q4_dot - w_9;
        let w_15 = S::from_f64(2.0) * w_14;
        let w_16 = w_13 - w_4 * w_15;
        let w_17 = cos_q4 * w_3;
        let w_18 = sin_q4 * w_2;
        let w_19 = w_17 + w_18;
        let w_43 = q5_dot + w_17 + w_18;
        let w_20 = cos_q4 * w_10;
        let w_21 = q4_dot * w_19 + w_20;
        let w_22 = w_21 * S::from_f64(3.0) - w_19 * w_15;
        let w_23 = w_14 * cos_q5;
        let w_24 = w_4 * sin_q5;
        let w_25 = w_23 - w_24;
        let w_102 = w_23 - w_24 + q6_dot;
        let w_26 = w_14 * sin_q5 + cos_q5 * w_4;
        let w_82 = q4_dot - w_14;
        let w_27 = w_25 * w_26;
        let w_28 = S::from_f64(0.002) * (w_13 - w_27);
        let w_29 = w
            * (S::from_f64(0.02) * (sin_q4 * w_16 - cos_q4 * w_22)
                - S::from_f64(0.01)
                    * (w_10 * S::from_f64(24.0) + w_9 * w_3 * S::from_f64(17.0))
                + sin_q4 * w_28);
        let w_117 = S::from_f64(0.02) * w_22;
        let w_128 = S::from_f64(0.02) * w_16 + w_28;
        let w_50 = self.d6 * (w_5 - w_27 - w_11);
        let w_30 = cos_q2 * w_7;
        let w_44 = w_7 * w;
        let w_31 = q3_dot + w_3;
        let w_32 = w_9 * w_31 + w_8;
        let w_33 = S::from_f64(2.0) * self.a2 * w_30 - self.d4 * w_32;
        let w_34 = cos_q4 * w_33;
        let q1_dot_squared = q1_dot * q1_dot;
        let w_35 = self.a2 * (q2_dot * q2_dot + q1_dot_squared * sin_q2 * sin_q2)
            + sin_q2 * q1_dot_squared * self.a1;
        let w_36 = cos_q3 * w_35;
        let w_52 = sin_q3 * w_35;
        let w_37 = w_9 * w_2;
        let w_38 = self.a2 * sin_q2;
        let w_39 = cos_q2 * q1_dot_squared * (self.a1 + w_38);
        let w_60 = self.a1 + w_38 + self.d4 * w;
        let w_134 = cos_q2 * q1_dot_squared;
        let w_40 = sin_q3 * w_39;
        let w_53 = cos_q3 * w_39;
        let w_41 = w_36 + self.d4 * w_37 + w_40;
        let w_56 = w_33 * sin_q4 + cos_q4 * w_41;
        let w_42 = sin_q4 * w_41;
        let w_45 = q3_dot * w_2 + w_44;
        let w_46 = sin_q5 * w_45;
        let w_47 = cos_q5 * w_21;
        let w_91 = sin_q5 * w_21;
        let w_48 = self.d6 * (w_25 * (q5_dot + w_43) - w_46 - w_47);
        let w_94 = q5_dot * w_25 - w_46 - w_47;
        let w_95 = S::from_f64(7.0) * w_94 + w_25 * w_43;
        let w_49 = w_34 - w_42 + w_48;
        let w_85 = w_34 - w_42;
        let w_97 = w_48 + w_85 * S::from_f64(5.0);
        let w_3_squared = w_3 * w_3;
        let w_51 = w_3_squared + w_2 * w_2;
        let w_54 = self.d4 * w_51 - w_52 + w_53;
        let w_136 = w_53 - w_52;
        let w_55 = sin_q5 * w_54;
        let w_70 = cos_q5 * w_54;
        let w_57 = cos_q5 * w_56;
        let w_58 = w_50 + w_55 + w_57;
        let w_98 = w_50 + S::from_f64(5.0) * (w_55 + w_57);
        let w_59 = cos_q6 * w_49 - sin_q6 * w_58;
        let w_69 = w_49 * sin_q6 + cos_q6 * w_58;
        let w_61 = cos_q4 * w_60;
        let w_62 = cos_q4 * w;
        let w_63 = cos_q5 * w_62 - w_6 * sin_q5;
        let w_88 = w_6 * cos_q5 + sin_q5 * w_62;
        let w_64 = self.d6 * w_63;
        let w_65 = w_61 + w_64;
        let w_66 = w * self.d6;
        let w_67 = cos_q5 * w_60;
        let w_68 = sin_q4 * (w_66 + w_67);
        let w_71 = sin_q5 * w_56;
        let w_72 = self.d6 * (w_43 * w_43 + w_26 * w_26);
        let w_73 = w_70 - w_71 + w_72;
        let w_113 = S::from_f64(5.0) * (w_70 - w_71) + w_72;
        let w_74 = w_60 * sin_q4 * sin_q5;
        let w_75 = self.m6
            * (w_59 * (cos_q6 * w_65 - sin_q6 * w_68)
                + w_69 * (sin_q6 * w_65 + cos_q6 * w_68) - w_73 * w_74);
        let w_76 = self.a1 * S::from_f64(20.0) + sin_q2 * self.a2 * S::from_f64(9.0);
        let w_77 = self.a2 * self.m2;
        let w_78 = q1_dot * q2_dot * cos_q2
            * (sin_q2 * S::from_f64(1.3) + w_76 * S::from_f64(0.045) * w_77);
        let w_79 = w_45 * S::from_f64(0.02);
        let w_80 = S::from_f64(0.01) * self.m4;
        let w_81 = self.d4 * S::from_f64(3.0);
        let w_83 = w_81 * (w_4 * w_82 - w_11) - w_56 * S::from_f64(10.0);
        let w_86 = S::from_f64(10.0) * w_85 + (w_20 + w_19 * w_82) * w_81;
        let w_141 = cos_q3
            * (w_51 * self.d4 * S::from_f64(10.0) + S::from_f64(10.0) * w_136
                - w_81 * (w_19 * w_19 + w_4 * w_4)) * self.a2 * self.m4
            * S::from_f64(0.1);
        let w_84 = w * w_81 - w_60 * S::from_f64(10.0);
        let w_87 = w_80 * (w_83 * sin_q4 * w_84 - w_86 * cos_q4 * w_84);
        let w_89 = q5_dot * w_26;
        let w_90 = cos_q5 * w_45;
        let w_92 = w_89 + w_90 - w_91;
        let w_93 = S::from_f64(5.0) * w_92 - w_43 * w_26;
        let w_116 = w_92 * S::from_f64(0.002);
        let w_96 = self.m5 * S::from_f64(0.04);
        let w_99 = w_96
            * (w_97 * (w_64 + w_61 * S::from_f64(5.0))
                + w_98 * sin_q4 * (w_66 + w_67 * S::from_f64(5.0)));
        let w_100 = cos_q6 * sin_q4;
        let w_101 = cos_q6 * w_26 - w_43 * sin_q6;
        let w_103 = S::from_f64(3.0) * (q6_dot * w_101 + cos_q6 * w_12 + sin_q6 * w_94)
            + w_101 * w_102;
        let w_105 = cos_q6 * w_43 + sin_q6 * w_26;
        let w_106 = S::from_f64(3.0) * (q6_dot * w_105 - cos_q6 * w_94 + sin_q6 * w_12)
            + w_102 * w_105;
        let w_104 = sin_q4 * sin_q6;
        let w_107 = S::from_f64(0.0005)
            * ((w * w_100 + sin_q6 * w_63) * w_103
                - (cos_q6 * w_63 - w * w_104) * w_106);
        let w_133 = S::from_f64(0.0005)
            * (w_103 * (cos_q6 * cos_q4 - cos_q5 * w_104)
                + w_106 * (cos_q5 * w_100 + cos_q4 * sin_q6));
        let w_108 = self.d4 * S::from_f64(20.0);
        let w_109 = S::from_f64(3.0) * (w_44 + w_31 * w_2)
            + w_30 * self.a2 * S::from_f64(200.0) - w_32 * w_108;
        let w_137 = S::from_f64(100.0) * w_136 + w_37 * S::from_f64(3.0) + w_51 * w_108;
        let w_138 = S::from_f64(3.0) * (w_3_squared + w_9 * w_9)
            + S::from_f64(100.0) * (w_36 + w_40) + w_37 * w_108;
        let w_135 = w_37 * S::from_f64(0.16);
        let w_110 = self.a2 * S::from_f64(100.0);
        let w_111 = S::from_f64(0.0001) * self.m3;
        let w_112 = w_109
            * (self.a1 * S::from_f64(100.0) + w_6 * S::from_f64(3.0) + sin_q2 * w_110
                + w * w_108) * w_111;
        let w_114 = S::from_f64(0.2) * self.m5;
        let w_115 = w_113 * w_114;
        let w_118 = S::from_f64(0.001) * (sin_q5 * w_93 + cos_q5 * w_95);
        let w_119 = sin_q5 * w_116;
        let w_120 = self.a2 * cos_q3;
        let w_121 = self.d4 - self.a2 * sin_q3;
        let w_129 = w_81 - S::from_f64(10.0) * w_121;
        let w_130 = w_80 * (w_86 * sin_q4 * w_129 + w_83 * cos_q4 * w_129);
        let w_122 = cos_q5 * w_120 + cos_q4 * sin_q5 * w_121;
        let w_123 = self.d6 * cos_q5;
        let w_124 = sin_q4 * (w_121 + w_123);
        let w_125 = cos_q5 * w_121;
        let w_126 = sin_q5 * w_120 - cos_q4 * (self.d6 + w_125);
        let w_127 = self.m6
            * (w_73 * w_122 + w_59 * (cos_q6 * w_124 - sin_q6 * w_126)
                + w_69 * (sin_q6 * w_124 + cos_q6 * w_126));
        let w_131 = self.a2 * S::from_f64(5.0);
        let w_132 = w_96
            * (w_97 * sin_q4 * (S::from_f64(5.0) * w_121 + w_123)
                + w_98
                    * (cos_q3 * sin_q5 * w_131
                        - cos_q4 * (self.d6 + S::from_f64(5.0) * w_125)));
        let w_139 = self.m3 * S::from_f64(0.002);
        let w_140 = w_138 * (self.d4 - sin_q3 * w_131) * w_139;
        let w_142 = self.d4 * self.m4 * S::from_f64(0.07);
        let w_143 = cos_q4
            * (w_128 - sin_q5 * (w_113 * self.d4 * w_114 + w_73 * self.m6 * self.d4)
                - w_83 * w_142);
        let w_144 = self.d4 * S::from_f64(5.0);
        let w_145 = w_96
            * (w_98 * cos_q4 * (self.d6 + cos_q5 * w_144)
                - w_97 * sin_q4 * (w_123 + w_144));
        let w_146 = sin_q4 * (self.d4 + w_123);
        let w_150 = self.d6 * w_96;
        let w_147 = cos_q4 * (self.d6 + self.d4 * cos_q5);
        let w_148 = self.m6
            * (w_59 * (cos_q6 * w_146 + sin_q6 * w_147)
                + w_69 * (sin_q6 * w_146 - cos_q6 * w_147));
        let w_149 = self.m6 * self.d6;
        let w_151 = sin_q5
            * (w_149 * (cos_q6 * w_59 + sin_q6 * w_69)
                + S::from_f64(0.0005) * (sin_q6 * w_103 - cos_q6 * w_106)
                + S::from_f64(0.001) * w_95 + w_97 * w_150);
        [
            w_29 + w_75 + w_78
                + w_6
                    * (S::from_f64(0.01) * (w_45 * S::from_f64(8.0) + w_3 * w_2) + w_79)
                + w_87 + S::from_f64(0.001) * (w_88 * w_93 + w_63 * w_95) + w_99 + w_107
                + w_112 - w_74 * w_115 + w_88 * w_116,
            sin_q4 * (w_117 - w_118 - w_119) - w_127 + cos_q4 * w_128 + w_130 - w_132
                + w_133 - sin_q2 * S::from_f64(0.65) * w_134 + w_135
                - w_76 * w_134 * w_77 * S::from_f64(0.0225)
                - w_111 * w_137 * (S::from_f64(3.0) + cos_q3 * w_110) + w_140 - w_141
                - w_115 * w_122,
            w_133 + w_135 + w_143 + sin_q4 * (w_117 - w_118 - w_119 - w_86 * w_142)
                + w_145 - w_148 - w_137 * self.m3 * S::from_f64(0.0003)
                + w_138 * self.d4 * w_139,
            w_151 - w_79 - cos_q5 * (S::from_f64(0.001) * w_93 + w_116),
            w_149 * (cos_q6 * w_69 - sin_q6 * w_59)
                + S::from_f64(0.0005) * (cos_q6 * w_103 + sin_q6 * w_106)
                + w_12 * S::from_f64(0.006) - w_27 * S::from_f64(0.002) + w_98 * w_150,
            S::from_f64(0.002) * (w_91 - w_89 - w_90),
        ]
    }
    /// Generalised forces `T_q' F`, 6: joules per unit of each coordinate.
    ///
    /// Operations: 76 additions, 144 multiplications, 5 sine-cosine pairs.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 6], qd: &[S; 6]) -> [S; 6] {
        let [_, q2, q3, q4, q5, q6] = *q;
        let [q1_dot, q2_dot, q3_dot, q4_dot, q5_dot, q6_dot] = *qd;
        let (
            [sin_q4,
            sin_q5,
            sin_q2,
            sin_q3,
            sin_q6,
            ],
            [cos_q4,
            cos_q5,
            cos_q2,
            cos_q3,
            cos_q6,
            ],
        ) = S::sin_cos_each([q4, q5, q2, q3, q6]);
        let w = sin_q2 * sin_q3;
        let w_2 = cos_q3 * cos_q2;
        let w_3 = w - w_2;
        let w_5 = w_2 - w;
        let w_4 = self.g * w_3;
        let w_6 = cos_q5 * cos_q4;
        let w_7 = sin_q2 * cos_q3 + cos_q2 * sin_q3;
        let w_8 = sin_q5 * w_7;
        let w_16 = self.g * w_7;
        let w_9 = self.d6 * (w_5 * w_6 - w_8);
        let w_10 = self.a1 + sin_q2 * self.a2 + self.d4 * w_5;
        let w_11 = cos_q4 * w_10;
        let w_12 = self.m5 * S::from_f64(0.2);
        let w_13 = self.d4 * S::from_f64(3.0);
        let w_14 = w_5 * w_13 - w_10 * S::from_f64(10.0);
        let w_25 = w_5 * self.d6;
        let w_15 = S::from_f64(0.1) * self.m4;
        let w_17 = sin_q5 * cos_q4;
        let w_18 = cos_q5 * w_16 - w_4 * w_17;
        let w_19 = w_18 * (self.m5 + self.m6);
        let w_20 = sin_q4
            * (w_4 * ((w_9 + w_11 * S::from_f64(5.0)) * w_12 - cos_q4 * w_14 * w_15)
                + sin_q5 * w_10 * w_19);
        let w_24 = w_11 + w_9;
        let w_26 = cos_q5 * w_10;
        let w_21 = sin_q4 * w_4;
        let w_22 = sin_q5 * w_16 + w_4 * w_6;
        let w_23 = cos_q6 * w_21 + sin_q6 * w_22;
        let w_28 = cos_q6 * w_22 - sin_q6 * w_21;
        let w_30 = w_22 * w_12;
        let w_27 = sin_q4 * (w_25 + w_26);
        let w_29 = self.m6
            * (w_23 * (cos_q6 * w_24 - sin_q6 * w_27)
                - w_28 * (sin_q6 * w_24 + cos_q6 * w_27));
        let w_31 = self.d4 - sin_q3 * self.a2;
        let w_32 = w_13 - S::from_f64(10.0) * w_31;
        let w_33 = self.a2 * S::from_f64(5.0);
        let w_34 = S::from_f64(0.2) * self.m3;
        let w_35 = cos_q5 * self.d6;
        let w_36 = sin_q4 * w_12;
        let w_37 = w_15 * (sin_q4 * sin_q4 * w_32 + cos_q4 * cos_q4 * w_32)
            - (self.d4 - sin_q3 * w_33) * w_34
            - sin_q4 * (w_35 + S::from_f64(5.0) * w_31) * w_36;
        let w_38 = w_16
            * (cos_q3 * self.a2 * self.m4
                + (S::from_f64(3.0) + cos_q3 * self.a2 * S::from_f64(100.0))
                    * S::from_f64(0.01) * self.m3);
        let w_39 = sin_q4 * (w_31 + w_35);
        let w_40 = sin_q5 * cos_q3;
        let w_41 = cos_q5 * w_31;
        let w_44 = w_30 * (w_40 * w_33 - cos_q4 * (self.d6 + S::from_f64(5.0) * w_41));
        let w_42 = self.a2 * w_40 - cos_q4 * (self.d6 + w_41);
        let w_43 = self.m6
            * (w_28 * (sin_q6 * w_39 + cos_q6 * w_42)
                - w_23 * (cos_q6 * w_39 - sin_q6 * w_42));
        let w_45 = sin_q4 * (self.d4 + w_35);
        let w_46 = cos_q4 * (self.d6 + cos_q5 * self.d4);
        let w_47 = self.m6
            * (w_28 * (sin_q6 * w_45 - cos_q6 * w_46)
                - w_23 * (cos_q6 * w_45 + sin_q6 * w_46));
        let w_48 = self.d4 * S::from_f64(5.0);
        let w_49 = w_4
            * (self.d4 * w_34 + self.d4 * self.m4 * S::from_f64(0.7)
                + w_36 * sin_q4 * (w_35 + w_48));
        let w_50 = self.c * S::from_f64(0.025);
        let w_51 = self.g * self.d6;
        let w_52 = w_12 * w_51 + self.m6 * w_51;
        [
            self.tau1.or(S::from_f64(0.0)) + w_20 + w_29 - q1_dot * self.c
                + cos_q4 * w_4 * sin_q4 * w_14 * w_15
                - sin_q4 * (w_25 + w_26 * S::from_f64(5.0)) * w_30,
            self.tau2.or(-S::from_f64(60.0)) + w_4 * w_37 + w_38 + w_43 - self.c * q2_dot
                + w_19 * (cos_q5 * cos_q3 * self.a2 + w_17 * w_31)
                + sin_q2 * self.g * self.a2 * S::from_f64(0.45) * self.m2 + w_44,
            self.tau3.or(-S::from_f64(20.0)) + w_47 - w_49 - self.c * q3_dot
                + w_16 * self.m3 * S::from_f64(0.03)
                + w_17 * w_18 * (self.m5 * self.d4 + self.d4 * self.m6)
                - w_30 * cos_q4 * (self.d6 + cos_q5 * w_48),
            self.tau4.or(S::from_f64(0.0)) - q4_dot * w_50
                + sin_q4 * sin_q5 * w_3 * w_52,
            self.tau5.or(S::from_f64(0.0)) - w_50 * q5_dot - w_52 * (w_8 + w_3 * w_6),
            self.tau6.or(S::from_f64(0.0)) - w_50 * q6_dot,
        ]
    }
    /// Constraints `C`, 0, in SI units; zero throughout the motion.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraints(&self, t: S, q: &[S; 6]) -> [S; 0] {
        []
    }
    /// The sum of the magnitudes of the terms of `C`, 0, in SI units: what its rounding is relative to.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_magnitudes(&self, t: S, q: &[S; 6]) -> [S; 0] {
        []
    }
    /// Constraint Jacobian `C_q`, 0 x 6: units of each constraint per unit of each coordinate.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_jacobian(&self, t: S, q: &[S; 6]) -> [[S; 6]; 0] {
        []
    }
    /// `C_t`, 0, units of `C` per second: the speeds obey `C_q q' + C_t = 0`.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_time_derivative(&self, t: S, q: &[S; 6]) -> [S; 0] {
        []
    }
    /// `(C_q q' + C_t)_q q' + (..)_t`, 0, units of `C` per second squared: the part of `C''` without accelerations.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 6], qd: &[S; 6]) -> [S; 0] {
        []
    }
    /// `C` (0), `C_q` (0 x 6) and `C_t` (0) together, in SI units, for projection.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 6],
    ) -> sim_kernel::ConstraintLinearization<[S; 0], [[S; 6]; 0]> {
        sim_kernel::ConstraintLinearization {
            values: [],
            jacobian: [],
            time_derivative: [],
        }
    }
    /// Kinetic energy `v' M v / 2`, in joules.
    ///
    /// Operations: 66 additions, 127 multiplications, 5 sine-cosine pairs.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 6], qd: &[S; 6]) -> S {
        let [_, q2, q3, q4, q5, q6] = *q;
        let [q1_dot, q2_dot, q3_dot, q4_dot, q5_dot, q6_dot] = *qd;
        let (
            [sin_q2,
            sin_q3,
            sin_q4,
            sin_q5,
            sin_q6,
            ],
            [cos_q2,
            cos_q3,
            cos_q4,
            cos_q5,
            cos_q6,
            ],
        ) = S::sin_cos_each([q2, q3, q4, q5, q6]);
        let w = q1_dot * q1_dot
            * (S::from_f64(0.4) + S::from_f64(0.08) * self.a1 * self.a1 * self.m1
                + S::from_f64(0.325) * sin_q2 * sin_q2);
        let a2_squared = self.a2 * self.a2;
        let w_2 = q2_dot * q2_dot
            * (S::from_f64(0.4) + a2_squared * S::from_f64(0.10125) * self.m2
                + cos_q3 * cos_q3 * S::from_f64(0.5) * a2_squared * self.m4);
        let w_3 = q2_dot + q3_dot;
        let w_4 = w_3 * cos_q4;
        let w_5 = q1_dot * (cos_q2 * cos_q3 - sin_q2 * sin_q3);
        let w_6 = w_5 * sin_q4;
        let w_7 = w_4 + w_6;
        let w_10 = w_4 + w_6 + q5_dot;
        let w_8 = w_5 * cos_q4 - w_3 * sin_q4;
        let w_9 = S::from_f64(0.03) * (w_7 * w_7 + w_8 * w_8);
        let w_11 = sin_q2 * cos_q3 + cos_q2 * sin_q3;
        let w_12 = q1_dot * w_11;
        let w_13 = q4_dot - w_12;
        let w_14 = w_13 * sin_q5 + w_8 * cos_q5;
        let w_15 = w_10 * cos_q6 + w_14 * sin_q6;
        let w_16 = w_14 * cos_q6 - w_10 * sin_q6;
        let w_17 = S::from_f64(0.00075) * (w_15 * w_15 + w_16 * w_16);
        let w_18 = S::from_f64(0.5) * self.m6;
        let w_19 = q1_dot * (self.a1 + sin_q2 * self.a2) + w_5 * self.d4;
        let w_20 = cos_q4 * w_19;
        let w_21 = w_3 * self.d4;
        let w_22 = q2_dot * sin_q3;
        let w_23 = w_21 - self.a2 * w_22;
        let w_30 = sin_q4 * w_19 + cos_q4 * w_23;
        let w_24 = sin_q4 * w_23;
        let w_25 = w_14 * self.d6;
        let w_26 = w_20 - w_24 + w_25;
        let w_40 = w_24 - w_20;
        let w_45 = w_25 - S::from_f64(5.0) * w_40;
        let w_27 = w_10 * self.d6;
        let w_28 = q2_dot * cos_q3;
        let w_29 = sin_q5 * w_28;
        let w_31 = cos_q5 * w_30;
        let w_32 = w_27 - self.a2 * w_29 + w_31;
        let w_33 = cos_q6 * w_26 - sin_q6 * w_32;
        let w_34 = sin_q6 * w_26 + cos_q6 * w_32;
        let w_35 = w_18 * (w_33 * w_33 + w_34 * w_34);
        let w_36 = self.a2 * S::from_f64(100.0);
        let w_38 = q1_dot
            * (self.a1 * S::from_f64(100.0) + w_11 * S::from_f64(3.0) + sin_q2 * w_36)
            + w_5 * self.d4 * S::from_f64(20.0);
        let w_37 = w_3 * S::from_f64(3.0) + w_28 * w_36;
        let w_39 = S::from_f64(5e-5) * self.m3 * (w_37 * w_37 + w_38 * w_38);
        let w_52 = cos_q5 * self.a2 * w_28 + sin_q5 * w_30;
        let w_53 = w_52 * w_52 * (S::from_f64(0.5) * self.m5 + w_18);
        let w_41 = self.d4 * S::from_f64(3.0);
        let w_42 = S::from_f64(10.0) * w_40 + w_8 * w_41;
        let w_43 = w_7 * w_41 - w_30 * S::from_f64(10.0);
        let w_44 = self.m4 * S::from_f64(0.005) * (w_42 * w_42 + w_43 * w_43);
        let w_50 = w_8 * sin_q5;
        let w_46 = self.a2 * S::from_f64(5.0);
        let w_47 = w_27 - w_29 * w_46 + w_31 * S::from_f64(5.0);
        let w_48 = self.m5 * S::from_f64(0.02) * (w_45 * w_45 + w_47 * w_47);
        let w_58 = w_21 - w_22 * w_46;
        let w_59 = w_58 * w_58 * self.m3 * S::from_f64(0.02);
        let w_49 = w_13 * cos_q5;
        let w_51 = w_49 - w_50;
        let w_54 = w_49 - w_50 + q6_dot;
        let w_55 = S::from_f64(0.001) * w_54 * w_54;
        let w_56 = q1_dot
            * (self.a1 * S::from_f64(20.0) + sin_q2 * self.a2 * S::from_f64(9.0));
        let w_57 = w_56 * w_56 * self.m2 * S::from_f64(0.00125);
        w + w_2 + w_9 + w_17 + w_35 + w_39 + w_44 + w_48 + S::from_f64(0.125) * w_3 * w_3
            + S::from_f64(0.12) * w_5 * w_5 + S::from_f64(0.04) * w_12 * w_12
            + S::from_f64(0.01) * w_13 * w_13 + S::from_f64(0.003) * w_10 * w_10
            + S::from_f64(0.0035) * w_14 * w_14 + S::from_f64(0.0025) * w_51 * w_51
            + w_53 + w_55 + w_57 + w_59
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: 57 additions, 103 multiplications, 5 sine-cosine pairs.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 6],
        qd: &[S; 6],
        qdd: &[S; 6],
        lambda: &[S; 0],
    ) -> S {
        let [_, q2, q3, q4, q5, q6] = *q;
        let [q1_dot, q2_dot, q3_dot, q4_dot, q5_dot, q6_dot] = *qd;
        let (
            [sin_q3,
            sin_q2,
            sin_q5,
            sin_q4,
            sin_q6,
            ],
            [cos_q3,
            cos_q2,
            cos_q5,
            cos_q4,
            cos_q6,
            ],
        ) = S::sin_cos_each([q3, q2, q5, q4, q6]);
        let w = cos_q3 * cos_q2 - sin_q2 * sin_q3;
        let w_2 = self.g * w;
        let w_8 = q1_dot * w;
        let w_3 = q2_dot + q3_dot;
        let w_4 = self.d4 * w_3;
        let w_5 = q2_dot * sin_q3;
        let w_6 = w_4 - self.a2 * w_5;
        let w_7 = sin_q4 * w_6;
        let w_9 = q1_dot * (self.a1 + self.a2 * sin_q2) + self.d4 * w_8;
        let w_16 = sin_q4 * w_9 + cos_q4 * w_6;
        let w_10 = w_9 * cos_q4;
        let w_11 = w_7 - w_10;
        let w_12 = w_8 * cos_q4 - sin_q4 * w_3;
        let w_15 = sin_q4 * w_8;
        let w_13 = self.d4 * S::from_f64(3.0);
        let w_14 = cos_q4 * w_3;
        let w_17 = self.m4 * S::from_f64(0.1)
            * (sin_q4 * (S::from_f64(10.0) * w_11 + w_12 * w_13)
                - cos_q4 * (w_13 * (w_14 + w_15) - w_16 * S::from_f64(10.0)));
        let w_28 = self.d6 * (q5_dot + w_14 + w_15);
        let w_18 = self.a2 * S::from_f64(5.0);
        let w_19 = cos_q3 * sin_q2 + cos_q2 * sin_q3;
        let w_20 = self.d6 * (sin_q5 * (q4_dot - w_19 * q1_dot) + cos_q5 * w_12);
        let w_23 = self.g * w_19;
        let w_27 = w_10 - w_7 + w_20;
        let w_21 = self.m5 * S::from_f64(0.2);
        let w_22 = w_2
            * (w_17 + (w_4 - w_5 * w_18) * self.m3 * S::from_f64(0.2)
                - sin_q4 * (w_20 - S::from_f64(5.0) * w_11) * w_21);
        let w_24 = q2_dot
            * (self.tau2.or(-S::from_f64(60.0)) - q2_dot * self.c
                + cos_q3 * w_23 * self.a2 * self.m4
                + sin_q2 * self.a2 * self.g * S::from_f64(0.45) * self.m2);
        let w_25 = q5_dot
            * (S::from_f64(40.0) * self.tau5.or(S::from_f64(0.0)) - q5_dot * self.c);
        let w_26 = S::from_f64(0.025)
            * (q6_dot
                * (S::from_f64(40.0) * self.tau6.or(S::from_f64(0.0)) - self.c * q6_dot)
                + q4_dot
                    * (S::from_f64(40.0) * self.tau4.or(S::from_f64(0.0))
                        - q4_dot * self.c) + w_25);
        let w_29 = q2_dot * cos_q3;
        let w_38 = w_23 * (w_3 * S::from_f64(3.0) + w_29 * self.a2 * S::from_f64(100.0))
            * S::from_f64(0.01) * self.m3;
        let w_30 = self.a2 * w_29;
        let w_31 = cos_q5 * w_16;
        let w_32 = w_28 - sin_q5 * w_30 + w_31;
        let w_33 = cos_q4 * w_2;
        let w_35 = sin_q4 * w_2;
        let w_37 = (cos_q5 * w_30 + sin_q5 * w_16) * (w_23 * cos_q5 + sin_q5 * w_33)
            * (self.m5 + self.m6);
        let w_34 = w_23 * sin_q5 - cos_q5 * w_33;
        let w_36 = (cos_q6 * w_27 - sin_q6 * w_32) * (sin_q6 * w_34 - cos_q6 * w_35)
            - (cos_q6 * w_34 + sin_q6 * w_35) * (w_27 * sin_q6 + cos_q6 * w_32);
        let w_39 = w_34 * (w_28 - sin_q5 * w_29 * w_18 + w_31 * S::from_f64(5.0)) * w_21;
        w_22 + w_24 + w_26 + self.m6 * w_36 + w_37
            + q1_dot * (self.tau1.or(S::from_f64(0.0)) - q1_dot * self.c)
            + q3_dot * (self.tau3.or(-S::from_f64(20.0)) - q3_dot * self.c) + w_38 - w_39
    }
    /// Outputs, 4, in SI units.
    ///
    /// Operations: 39 additions, 70 multiplications, 5 sine-cosine pairs, 1 square root.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 6],
        qd: &[S; 6],
        qdd: &[S; 6],
        lambda: &[S; 0],
    ) -> RobotArmOutputs<S> {
        let [q1, q2, q3, q4, q5, _] = *q;
        let [q1_dot, q2_dot, q3_dot, q4_dot, q5_dot, _] = *qd;
        let (
            [sin_q1,
            sin_q2,
            sin_q3,
            sin_q5,
            sin_q4,
            ],
            [cos_q1,
            cos_q2,
            cos_q3,
            cos_q5,
            cos_q4,
            ],
        ) = S::sin_cos_each([q1, q2, q3, q5, q4]);
        let w = self.a1 + self.a2 * sin_q2;
        let w_2 = cos_q2 * cos_q3 - sin_q2 * sin_q3;
        let w_3 = cos_q1 * w_2;
        let w_4 = cos_q2 * sin_q3 + sin_q2 * cos_q3;
        let w_5 = w_2 * sin_q1;
        let w_6 = w_2 * q1_dot;
        let w_7 = q2_dot + q3_dot;
        let w_8 = sin_q5 * (q4_dot - w_4 * q1_dot)
            + cos_q5 * (cos_q4 * w_6 - sin_q4 * w_7);
        let w_9 = q5_dot + cos_q4 * w_7 + sin_q4 * w_6;
        let w_10 = self.d6 * (cos_q4 * w_8 + cos_q5 * sin_q4 * w_9) + w * q1_dot
            + self.d4 * w_6;
        let w_13 = self.d6 * (sin_q4 * w_8 - cos_q5 * cos_q4 * w_9);
        let w_11 = self.d4 * w_7;
        let w_12 = w_4 * w_11;
        let w_14 = self.d6 * sin_q5;
        let w_15 = sin_q3 * w_13 - cos_q3 * w_9 * w_14;
        let w_16 = sin_q3 * w_9 * w_14 + cos_q3 * w_13;
        let w_17 = cos_q2 * w_15 + sin_q2 * w_16;
        let w_18 = self.a2 * q2_dot;
        let w_22 = sin_q2 * (w_15 + w_18) + w_2 * w_11 - cos_q2 * w_16;
        let w_19 = cos_q2 * w_18;
        let w_20 = sin_q1 * w_10 + cos_q1 * (w_12 - w_17 - w_19);
        let w_21 = cos_q1 * w_10 + sin_q1 * (w_17 - w_12 + w_19);
        [
            cos_q1 * w + self.d4 * w_3
                + self.d6
                    * (w_3 * cos_q5
                        - (sin_q1 * sin_q4 + cos_q1 * w_4 * cos_q4) * sin_q5),
            sin_q1 * w + self.d4 * w_5
                + self.d6
                    * (cos_q5 * w_5
                        - sin_q5 * (cos_q4 * sin_q1 * w_4 - cos_q1 * sin_q4)),
            self.h + self.a2 * cos_q2 - self.d4 * w_4
                - self.d6 * (cos_q5 * w_4 + w_2 * cos_q4 * sin_q5),
            (w_20 * w_20 + w_21 * w_21 + w_22 * w_22).sqrt(),
        ]
            .into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 4, in SI units per second.
    ///
    /// Operations: 109 additions, 170 multiplications, 1 division, 5 sine-cosine pairs, 1 square root.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 6],
        qd: &[S; 6],
        qdd: &[S; 6],
    ) -> RobotArmOutputRates<S> {
        let [q1, q2, q3, q4, q5, _] = *q;
        let [q1_dot, q2_dot, q3_dot, q4_dot, q5_dot, _] = *qd;
        let [q1_ddot, q2_ddot, q3_ddot, q4_ddot, q5_ddot, _] = *qdd;
        let (
            [sin_q1,
            sin_q2,
            sin_q3,
            sin_q5,
            sin_q4,
            ],
            [cos_q1,
            cos_q2,
            cos_q3,
            cos_q5,
            cos_q4,
            ],
        ) = S::sin_cos_each([q1, q2, q3, q5, q4]);
        let w = q2_dot * self.a2;
        let w_2 = cos_q2 * w;
        let w_3 = self.a1 + self.a2 * sin_q2;
        let w_4 = sin_q2 * cos_q3 + cos_q2 * sin_q3;
        let w_5 = cos_q2 * cos_q3 - sin_q2 * sin_q3;
        let w_6 = sin_q1 * w_5;
        let w_7 = cos_q1 * (q2_dot * w_4 + q3_dot * w_4) + q1_dot * w_6;
        let w_8 = cos_q1 * w_4;
        let w_9 = q1_dot * cos_q1;
        let w_10 = q2_dot + q3_dot;
        let w_11 = w_5 * w_10;
        let w_12 = q1_dot * sin_q1;
        let w_13 = sin_q5
            * (sin_q4 * (w_9 - q4_dot * w_8)
                + cos_q4 * (cos_q1 * w_11 - w_4 * w_12 + sin_q1 * q4_dot)
                + q5_dot * cos_q1 * w_5);
        let w_14 = w_4 * w_10;
        let w_15 = w_5 * w_9 - sin_q1 * w_14;
        let w_16 = sin_q1 * w_4;
        let w_17 = sin_q5
            * (cos_q4 * (w_4 * w_9 + sin_q1 * w_11 - cos_q1 * q4_dot)
                + sin_q4 * (w_12 - q4_dot * w_16) + w_6 * q5_dot);
        let w_18 = self.d4 * w_11;
        let w_19 = sin_q2 * w + w_18
            + self.d6
                * (cos_q5 * (w_11 + w_5 * q5_dot * cos_q4)
                    - sin_q5 * (w_4 * q5_dot + cos_q4 * w_14 + w_5 * sin_q4 * q4_dot));
        let w_20 = q4_dot - q1_dot * w_4;
        let w_21 = q1_dot * w_5;
        let w_22 = cos_q4 * w_21 - sin_q4 * w_10;
        let w_23 = sin_q5 * w_20 + cos_q5 * w_22;
        let w_24 = q5_dot + cos_q4 * w_10 + sin_q4 * w_21;
        let w_25 = cos_q5 * w_24;
        let w_33 = sin_q5 * w_24;
        let w_26 = cos_q4 * w_23 + sin_q4 * w_25;
        let w_31 = sin_q4 * w_23 - cos_q4 * w_25;
        let w_27 = self.d6 * w_26;
        let w_28 = self.d4 * w_21;
        let w_29 = w_27 + q1_dot * w_3 + w_28;
        let w_56 = q1_dot * (w_27 + w_28);
        let w_30 = self.d4 * w_14;
        let w_32 = self.d6 * w_31;
        let w_34 = sin_q3 * w_32 - cos_q3 * self.d6 * w_33;
        let w_35 = sin_q3 * self.d6;
        let w_36 = w_33 * w_35 + cos_q3 * w_32;
        let w_40 = sin_q2 * (w_34 + w) + w_18 - cos_q2 * w_36;
        let w_37 = cos_q2 * w_34 + sin_q2 * w_36;
        let w_38 = sin_q1 * w_29 + cos_q1 * (w_30 - w_37 - w_2);
        let w_39 = cos_q1 * w_29 + sin_q1 * (w_37 - w_30 + w_2);
        let w_41 = w_38 * w_38 + w_39 * w_39 + w_40 * w_40;
        let w_42 = q2_ddot + q3_ddot;
        let w_44 = w_42 + q4_dot * w_21;
        let w_43 = self.d4 * (w_10 * w_11 + w_4 * w_42);
        let w_45 = q1_dot * w_14 - w_5 * q1_ddot;
        let w_46 = w_45 + q4_dot * w_10;
        let w_50 = cos_q5 * (q5_dot * w_20 - (sin_q4 * w_44 + cos_q4 * w_46))
            + sin_q5 * (q4_ddot - q1_dot * w_11 - w_4 * q1_ddot - q5_dot * w_22);
        let w_47 = q5_ddot + cos_q4 * w_44 - sin_q4 * w_46;
        let w_48 = q5_dot * w_25 + sin_q5 * w_47;
        let w_49 = q5_dot * w_33 - cos_q5 * w_47;
        let w_51 = self.d6 * (cos_q4 * w_49 + q4_dot * w_26 + sin_q4 * w_50);
        let w_52 = q3_dot * w_36 - self.d6 * cos_q3 * w_48 + sin_q3 * w_51
            + q2_dot * w_36;
        let w_53 = w_35 * w_48 - q3_dot * w_34 + cos_q3 * w_51 - q2_dot * w_34;
        let w_58 = self.d6 * (cos_q4 * w_50 - q4_dot * w_31 - sin_q4 * w_49)
            + q1_dot * (w_37 - w_30 + q2_dot * cos_q2 * self.a2 * S::from_f64(2.0))
            + w_3 * q1_ddot - self.d4 * w_45;
        let w_54 = cos_q2 * w_52 + sin_q2 * w_53;
        let q2_dot_squared = q2_dot * q2_dot;
        let w_60 = w_40
            * (self.a2 * (sin_q2 * q2_ddot + cos_q2 * q2_dot_squared)
                + self.d4 * (w_5 * w_42 - w_10 * w_14) - cos_q2 * w_53 + sin_q2 * w_52);
        let w_55 = self.a2 * (sin_q2 * q2_dot_squared - cos_q2 * q2_ddot);
        let w_57 = w_3 * q1_dot * q1_dot;
        let w_59 = w_39 * (cos_q1 * w_58 + sin_q1 * (w_54 - w_43 - w_55 - w_56 - w_57));
        [
            cos_q1 * w_2 - q1_dot * sin_q1 * w_3 - self.d4 * w_7
                - self.d6
                    * (cos_q5 * (w_7 + q5_dot * (sin_q1 * sin_q4 + cos_q4 * w_8))
                        + w_13),
            w_9 * w_3 + sin_q1 * w_2 + self.d4 * w_15
                + self.d6
                    * (cos_q5 * (w_15 - q5_dot * (cos_q4 * w_16 - cos_q1 * sin_q4))
                        - w_17),
            -w_19,
            w_41.sqrt()
                * (w_38 * (cos_q1 * (w_43 - w_54 + w_55 + w_56 + w_57) + sin_q1 * w_58)
                    + w_59 + w_60) / w_41,
        ]
            .into()
    }
    /// `left - right` of each event, 0, in SI units: zero when it happens.
    ///
    /// Operations: none.
    #[inline]
    pub fn events(
        &self,
        t: S,
        q: &[S; 6],
        qd: &[S; 6],
        qdd: &[S; 6],
        lambda: &[S; 0],
    ) -> [S; 0] {
        []
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 38 additions, 52 multiplications, 6 sine-cosine pairs.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 6]) -> [S; 36] {
        let [q1, q2, q3, q4, q5, q6] = *q;
        let (
            [sin_q1,
            sin_q2,
            sin_q3,
            sin_q5,
            sin_q4,
            sin_q6,
            ],
            [cos_q1,
            cos_q2,
            cos_q3,
            cos_q5,
            cos_q4,
            cos_q6,
            ],
        ) = S::sin_cos_each([q1, q2, q3, q5, q4, q6]);
        let shoulder_x = self.a1 * cos_q1;
        let shoulder_y = self.a1 * sin_q1;
        let w = self.a1 + self.a2 * sin_q2;
        let elbow_x = cos_q1 * w;
        let elbow_y = sin_q1 * w;
        let w_2 = self.a2 * cos_q2;
        let elbow_z = self.h + w_2;
        let w_3 = cos_q2 * cos_q3 - sin_q2 * sin_q3;
        let w_4 = cos_q1 * w_3;
        let w_5 = self.d4 * w_4;
        let wrist_x = elbow_x + w_5;
        let w_6 = sin_q1 * w_3;
        let w_7 = self.d4 * w_6;
        let wrist_y = elbow_y + w_7;
        let w_8 = sin_q2 * cos_q3 + cos_q2 * sin_q3;
        let w_9 = self.d4 * w_8;
        let wrist_z = self.h + w_2 - w_9;
        let w_10 = cos_q1 * w_8;
        let w_11 = sin_q1 * sin_q4 + w_10 * cos_q4;
        let w_12 = self.d6 * (w_4 * cos_q5 - w_11 * sin_q5);
        let flange_x = elbow_x + w_5 + w_12;
        let w_13 = sin_q1 * w_8;
        let w_14 = cos_q4 * w_13 - cos_q1 * sin_q4;
        let w_15 = self.d6 * (w_6 * cos_q5 - sin_q5 * w_14);
        let flange_y = elbow_y + w_7 + w_15;
        let w_16 = self.d6 * (w_8 * cos_q5 + w_3 * cos_q4 * sin_q5);
        let flange_z = self.h + w_2 - w_9 - w_16;
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            self.h,
            shoulder_x,
            shoulder_y,
            self.h,
            shoulder_x,
            shoulder_y,
            self.h,
            elbow_x,
            elbow_y,
            elbow_z,
            elbow_x,
            elbow_y,
            elbow_z,
            wrist_x,
            wrist_y,
            wrist_z,
            wrist_x,
            wrist_y,
            wrist_z,
            flange_x,
            flange_y,
            flange_z,
            flange_x,
            flange_y,
            flange_z,
            elbow_x + w_5 + w_12
                + S::from_f64(0.05)
                    * ((sin_q4 * w_10 - sin_q1 * cos_q4) * cos_q6
                        + (w_4 * sin_q5 + cos_q5 * w_11) * sin_q6),
            elbow_y + w_7 + w_15
                + S::from_f64(0.05)
                    * (cos_q6 * (cos_q1 * cos_q4 + sin_q4 * w_13)
                        + sin_q6 * (w_6 * sin_q5 + cos_q5 * w_14)),
            self.h + w_2 - w_9 - w_16
                + S::from_f64(0.05)
                    * (w_3 * sin_q4 * cos_q6
                        + sin_q6 * (w_3 * cos_q5 * cos_q4 - w_8 * sin_q5)),
        ]
    }
    /// Declared start: values or guesses of the coordinates (6), and speeds (6), in SI units; 0 where nothing is declared.
    ///
    /// Operations: 1 addition, 4 multiplications.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 6]> {
        sim_kernel::Initial {
            positions: [
                S::from_f64(0.0),
                S::from_f64(0.1111111111111111) * S::from_f64(::core::f64::consts::PI),
                -(S::from_f64(::core::f64::consts::PI)
                    * S::from_f64(0.16666666666666666)),
                S::from_f64(::core::f64::consts::PI) * S::from_f64(0.05555555555555555),
                S::from_f64(::core::f64::consts::PI) * S::from_f64(0.2222222222222222),
                S::from_f64(0.0),
            ],
            speeds: [
                S::from_f64(0.5),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
        }
    }
    /// The inputs, 6, in SI units: what each is held at, or its declared course.
    ///
    /// Operations: 2 additions.
    #[inline]
    pub fn input_values(&self, t: S, q: &[S; 6]) -> [S; 6] {
        [
            self.tau1.or(S::from_f64(0.0)),
            self.tau2.or(-S::from_f64(60.0)),
            self.tau3.or(-S::from_f64(20.0)),
            self.tau4.or(S::from_f64(0.0)),
            self.tau5.or(S::from_f64(0.0)),
            self.tau6.or(S::from_f64(0.0)),
        ]
    }
    /// [`RobotArmPrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 6],
        qd: &[S; 6],
    ) -> sim_kernel::Dynamics<S, [S; 6], [S; 0]> {
        self.prepare().dynamics(t, q, qd)
    }
    /// [`RobotArmPrepared::inverse_dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn inverse_dynamics(
        &self,
        t: S,
        q: &[S; 6],
        qd: &[S; 6],
        qdd: &[S; 6],
    ) -> [S; 6] {
        self.prepare().inverse_dynamics(t, q, qd, qdd)
    }
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> RobotArmPrepared<S> {
    /// Accelerations (6), multipliers (0) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 389 additions, 590 multiplications, 5 divisions, 5 sine-cosine pairs.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 6],
        qd: &[S; 6],
    ) -> sim_kernel::Dynamics<S, [S; 6], [S; 0]> {
        let [_, q2, q3, q4, q5, q6] = *q;
        let [q1_dot, q2_dot, q3_dot, q4_dot, q5_dot, q6_dot] = *qd;
        let tau5 = self.tau5.or(S::from_f64(0.0));
        let (
            [sin_q4,
            sin_q5,
            sin_q2,
            sin_q3,
            sin_q6,
            ],
            [cos_q4,
            cos_q5,
            cos_q2,
            cos_q3,
            cos_q6,
            ],
        ) = S::sin_cos_each([q4, q5, q2, q3, q6]);
        let w = sin_q2 * cos_q3 + cos_q2 * sin_q3;
        let w_2 = w * q1_dot;
        let w_3 = q4_dot - w_2;
        let w_4 = cos_q2 * cos_q3 - sin_q2 * sin_q3;
        let w_5 = w_4 * q1_dot;
        let w_6 = q2_dot + q3_dot;
        let w_7 = cos_q4 * w_5 - sin_q4 * w_6;
        let w_8 = sin_q5 * w_3 + cos_q5 * w_7;
        let w_9 = cos_q4 * w_6;
        let w_10 = sin_q4 * w_5;
        let w_11 = w_9 + w_10 + q5_dot;
        let w_25 = w_9 + w_10;
        let w_12 = cos_q6 * w_8 - sin_q6 * w_11;
        let w_13 = q4_dot * w_7;
        let w_14 = q1_dot * q2_dot;
        let w_15 = w * w_14;
        let w_16 = q3_dot * w_2 + w_15;
        let w_17 = sin_q4 * w_16;
        let w_18 = w_13 - w_17;
        let w_19 = cos_q5 * w_3;
        let w_20 = sin_q5 * w_7;
        let w_21 = w_19 - w_20;
        let w_30 = w_19 - w_20 + q6_dot;
        let w_22 = w_4 * w_14;
        let w_34 = cos_q2 * w_14;
        let w_23 = q3_dot * w_5 + w_22;
        let w_24 = sin_q5 * w_23;
        let w_26 = cos_q4 * w_16;
        let w_27 = q4_dot * w_25 + w_26;
        let w_28 = cos_q5 * w_27;
        let w_29 = q5_dot * w_21 - w_24 - w_28;
        let w_31 = S::from_f64(3.0) * (q6_dot * w_12 + cos_q6 * w_18 + sin_q6 * w_29)
            + w_12 * w_30;
        let w_49 = self.d6 * (w_21 * (q5_dot + w_11) - w_24 - w_28);
        let w_32 = cos_q6 * w_11 + sin_q6 * w_8;
        let w_33 = S::from_f64(3.0) * (q6_dot * w_32 - cos_q6 * w_29 + sin_q6 * w_18)
            + w_30 * w_32;
        let w_65 = S::from_f64(7.0) * w_29 + w_11 * w_21;
        let w_58 = w_8 * w_21;
        let w_59 = self.d6 * (w_13 - w_17 - w_58);
        let w_35 = q3_dot + w_6;
        let w_36 = w_15 + w_2 * w_35;
        let w_37 = w_34 * self.k_33 - self.d4 * w_36;
        let w_38 = cos_q4 * w_37;
        let sin_q2_squared = sin_q2 * sin_q2;
        let q1_dot_squared = q1_dot * q1_dot;
        let w_39 = sin_q2 * q1_dot_squared;
        let w_40 = self.a2 * (q2_dot * q2_dot + sin_q2_squared * q1_dot_squared)
            + self.a1 * w_39 - cos_q2 * self.g;
        let w_41 = cos_q3 * w_40;
        let w_52 = sin_q3 * w_40;
        let w_42 = w_5 * w_2;
        let w_43 = self.a2 * sin_q2;
        let w_44 = self.a1 + w_43;
        let w_84 = self.a1 + w_43 + self.d4 * w_4;
        let w_45 = cos_q2 * q1_dot_squared * w_44 + sin_q2 * self.g;
        let w_188 = q1_dot * w_44 + self.d4 * w_5;
        let w_46 = sin_q3 * w_45;
        let w_53 = cos_q3 * w_45;
        let w_47 = w_41 + self.d4 * w_42 + w_46;
        let w_56 = sin_q4 * w_37 + cos_q4 * w_47;
        let w_48 = sin_q4 * w_47;
        let w_50 = w_38 - w_48 + w_49;
        let w_66 = w_38 - w_48;
        let w_67 = S::from_f64(5.0) * w_66 + w_49;
        let w_6_squared = w_6 * w_6;
        let w_155 = S::from_f64(3.0) * (w_6_squared + w_2 * w_2)
            + S::from_f64(100.0) * (w_41 + w_46) + self.k_5 * w_42;
        let w_51 = w_6_squared + w_5 * w_5;
        let w_54 = self.d4 * w_51 - w_52 + w_53;
        let w_151 = w_53 - w_52;
        let w_55 = sin_q5 * w_54;
        let w_82 = cos_q5 * w_54;
        let w_57 = cos_q5 * w_56;
        let w_60 = w_55 + w_57 + w_59;
        let w_63 = S::from_f64(5.0) * (w_55 + w_57) + w_59;
        let w_61 = cos_q6 * w_50 - sin_q6 * w_60;
        let w_62 = sin_q6 * w_50 + cos_q6 * w_60;
        let rhs_q5 = tau5 - S::from_f64(0.0005) * (cos_q6 * w_31 + sin_q6 * w_33)
            + self.k_25 * (sin_q6 * w_61 - cos_q6 * w_62) - S::from_f64(0.006) * w_18
            + S::from_f64(0.002) * w_58 - q5_dot * self.k_43 - self.k_26 * w_63;
        let w_74 = S::from_f64(3.0) * w_18;
        let w_76 = S::from_f64(0.002) * (w_74 - w_58);
        let w_64 = S::from_f64(0.02) * w_23;
        let tau4 = self.tau4.or(S::from_f64(0.0));
        let w_68 = sin_q5
            * (S::from_f64(0.0005) * (cos_q6 * w_33 - sin_q6 * w_31)
                - self.k_25 * (cos_q6 * w_61 + sin_q6 * w_62) - S::from_f64(0.001) * w_65
                - self.k_26 * w_67);
        let w_69 = q5_dot * w_8 + cos_q5 * w_23 - sin_q5 * w_27;
        let w_97 = w
            * (S::from_f64(0.01) * (S::from_f64(8.0) * w_23 + w_5 * w_6) + w_64);
        let w_70 = S::from_f64(5.0) * w_69 - w_8 * w_11;
        let w_71 = S::from_f64(0.002) * w_69;
        let rhs_q4 = w_64 + tau4 + w_68 + cos_q5 * (S::from_f64(0.001) * w_70 + w_71)
            - q4_dot * self.k_43;
        let tau1 = self.tau1.or(S::from_f64(0.0));
        let w_72 = S::from_f64(2.0) * w_3;
        let w_73 = S::from_f64(3.0) * w_27 - w_72 * w_25;
        let w_75 = w_74 - w_7 * w_72;
        let w_77 = w_4
            * (S::from_f64(0.02) * (cos_q4 * w_73 - sin_q4 * w_75)
                + S::from_f64(0.01)
                    * (S::from_f64(24.0) * w_16 + w_6 * w_2 * S::from_f64(17.0))
                - sin_q4 * w_76);
        let w_122 = S::from_f64(0.02) * w_73;
        let w_134 = S::from_f64(0.02) * w_75 + w_76;
        let w_106 = q4_dot - w_3;
        let w_107 = S::from_f64(10.0) * w_66 + self.k_6 * (w_26 + w_25 * w_106);
        let w_109 = self.k_6 * (w_7 * w_106 - w_17) - S::from_f64(10.0) * w_56;
        let w_81 = sin_q5 * w_56;
        let w_78 = self.k + sin_q2 * self.k_2;
        let w_148 = (cos_q2 * w_78 * q1_dot_squared + sin_q2 * self.k_36) * self.k_38;
        let w_79 = q1_dot
            * (self.c
                + cos_q2 * q2_dot * (sin_q2 * S::from_f64(1.3) + w_78 * self.k_34));
        let w_80 = self.d6 * (w_11 * w_11 + w_8 * w_8);
        let w_193 = self.d6 * w_8;
        let w_199 = self.d6 * w_11;
        let w_83 = w_80 - w_81 + w_82;
        let w_116 = w_80 + S::from_f64(5.0) * (w_82 - w_81);
        let w_85 = sin_q4 * sin_q5;
        let w_86 = w_84 * w_85;
        let w_87 = w_84 * cos_q4;
        let w_88 = w_4 * cos_q4;
        let w_89 = cos_q5 * w_88 - sin_q5 * w;
        let w_90 = self.d6 * w_89;
        let w_91 = w_87 + w_90;
        let w_110 = w_90 + w_87 * S::from_f64(5.0);
        let w_92 = w_4 * self.d6;
        let w_93 = sin_q4 * (w_92 + w_84 * cos_q5);
        let w_94 = cos_q6 * w_91 - sin_q6 * w_93;
        let w_95 = w_91 * sin_q6 + cos_q6 * w_93;
        let w_96 = self.m6 * (w_83 * w_86 - w_94 * w_61 - w_95 * w_62);
        let w_98 = sin_q5 * cos_q4;
        let w_99 = cos_q5 * w + w_4 * w_98;
        let w_100 = sin_q4 * sin_q6;
        let w_101 = cos_q6 * w_89 - w_4 * w_100;
        let w_102 = sin_q4 * cos_q6;
        let w_103 = w_4 * w_102 + w_89 * sin_q6;
        let w_104 = w_4 * self.k_6 - w_84 * S::from_f64(10.0);
        let w_105 = cos_q4 * w_104;
        let w_108 = sin_q4 * w_104;
        let w_111 = cos_q5 * S::from_f64(5.0);
        let w_112 = sin_q4 * (w_92 + w_84 * w_111);
        let w_113 = self.k_10 * (w_110 * w_67 + w_112 * w_63);
        let w_114 = self.k_3 + w * S::from_f64(3.0) + sin_q2 * self.k_4 + w_4 * self.k_5;
        let w_115 = w_114 * self.k_8
            * (S::from_f64(3.0) * (w_22 + w_5 * w_35) + self.k_32 * w_34
                - self.k_5 * w_36);
        let w_117 = w_116 * self.k_35;
        let w_118 = tau1 + w_77 - w_79 + w_96 - w_97
            - S::from_f64(0.001) * (w_99 * w_70 + w_89 * w_65)
            + S::from_f64(0.0005) * (w_101 * w_33 - w_103 * w_31)
            + self.k_9 * (w_105 * w_107 - w_108 * w_109) - w_113 - w_115 - w_99 * w_71
            + w_86 * w_117;
        let w_121 = S::from_f64(0.001) * (sin_q5 * w_70 + cos_q5 * w_65);
        let w_167 = cos_q4
            * (sin_q5 * (self.k_18 * w_83 + w_116 * self.k_42) - w_134
                + self.k_19 * w_109);
        let w_119 = sin_q2 * self.k_29;
        let mass_q5_q1 = sin_q4
            * (cos_q5 * (self.k_28 + w_119 + w_4 * self.k_30) + w_4 * self.k_31);
        let l_q1_q5 = mass_q5_q1 * self.inverse_q5;
        let w_120 = self.k_30 + cos_q5 * self.k_27;
        let sin_q5_squared = sin_q5 * sin_q5;
        let mass_q4_q4 = S::from_f64(0.027) + sin_q5_squared * self.k_27;
        let mass_q4_q1 = sin_q5 * cos_q4 * (self.k_28 + w_4 * w_120 + w_119)
            - w * mass_q4_q4;
        let inverse_q4 = S::from_f64(1.0) / mass_q4_q4;
        let l_q1_q4 = mass_q4_q1 * inverse_q4;
        let rhs_q1 = w_118 - rhs_q5 * l_q1_q5 - rhs_q4 * l_q1_q4;
        let tau2 = self.tau2.or(-S::from_f64(60.0));
        let w_123 = sin_q5 * w_71;
        let w_124 = cos_q3 * cos_q5;
        let w_125 = self.d4 - self.a2 * sin_q3;
        let w_126 = self.a2 * w_124 + w_98 * w_125;
        let w_127 = self.d6 * cos_q5;
        let w_128 = sin_q4 * (w_125 + w_127);
        let w_129 = sin_q5 * cos_q3;
        let w_130 = self.a2 * w_129 - cos_q4 * (self.d6 + cos_q5 * w_125);
        let w_131 = cos_q6 * w_128 - sin_q6 * w_130;
        let w_132 = sin_q6 * w_128 + cos_q6 * w_130;
        let w_133 = self.m6 * (w_126 * w_83 + w_131 * w_61 + w_132 * w_62);
        let w_135 = cos_q6 * cos_q4 - cos_q5 * w_100;
        let w_136 = cos_q5 * w_102 + cos_q4 * sin_q6;
        let w_137 = S::from_f64(0.0005) * (w_135 * w_31 + w_136 * w_33);
        let w_138 = self.k_6 - S::from_f64(10.0) * w_125;
        let w_139 = sin_q4 * w_138;
        let w_140 = cos_q4 * w_138;
        let w_141 = self.k_9 * (w_139 * w_107 + w_140 * w_109);
        let w_168 = sin_q4 * (w_121 - w_122 + w_123 + self.k_19 * w_107);
        let w_142 = sin_q4 * (S::from_f64(5.0) * w_125 + w_127);
        let w_143 = self.k_13 * w_129;
        let w_144 = w_143 - cos_q4 * (self.d6 + w_111 * w_125);
        let w_145 = self.k_10 * (w_142 * w_67 + w_144 * w_63);
        let w_146 = S::from_f64(0.16) * w_42;
        let w_152 = S::from_f64(100.0) * w_151 + S::from_f64(3.0) * w_42
            + self.k_5 * w_51;
        let w_156 = cos_q3
            * (w_51 * self.k_37 - self.k_6 * (w_25 * w_25 + w_7 * w_7)
                + S::from_f64(10.0) * w_151) * self.k_40;
        let w_147 = self.c * q2_dot;
        let w_149 = cos_q3 * self.k_4;
        let w_150 = S::from_f64(3.0) + w_149;
        let w_153 = sin_q3 * self.k_13;
        let w_154 = self.d4 - w_153;
        let w_157 = tau2 + sin_q4 * (w_121 - w_122 + w_123) + w_133 - cos_q4 * w_134
            - w_137 - w_141 + w_145 + cos_q2 * S::from_f64(0.65) * w_39 - w_146 - w_147
            + w_148 + self.k_8 * w_150 * w_152 - w_154 * w_155 * self.k_39 + w_156
            + w_126 * w_117;
        let w_158 = sin_q3 * self.k_29;
        let mass_q5_q2 = cos_q4 * (self.k_31 + cos_q5 * (self.k_30 - w_158))
            - w_129 * self.k_29;
        let mass_q4_q2 = sin_q4 * sin_q5 * (w_158 - w_120);
        let minus_mass_q4_q3 = w_120 * w_85;
        let mass_q6_q2 = w_85 * S::from_f64(0.002);
        let l_q2_q5 = mass_q5_q2 * self.inverse_q5;
        let l_q2_q4 = mass_q4_q2 * inverse_q4;
        let sin_q4_squared = sin_q4 * sin_q4;
        let w_4_squared = w_4 * w_4;
        let w_159 = sin_q4_squared
            * (sin_q5_squared * w_84 * w_84 * self.k_11
                + w_4_squared * S::from_f64(0.006));
        let w_181 = sin_q4_squared * S::from_f64(0.001);
        let w_160 = self.k_9 * (w_105 * w_105 + w_108 * w_108);
        let w_161 = S::from_f64(0.007) * (w_99 * w_99 + w_89 * w_89);
        let w_164 = cos_q5 * w_89;
        let w_165 = sin_q4
            * (sin_q5 * (w_84 * self.k_11 * w_126 - S::from_f64(0.007) * w_99)
                + w_88 * S::from_f64(0.006) - S::from_f64(0.007) * w_164);
        let w_177 = sin_q4
            * (cos_q4 * (sin_q5_squared * w_84 * self.k_20 + w_4 * S::from_f64(0.006))
                - S::from_f64(0.007) * (sin_q5 * w_99 + w_164) + w_105 * self.k_19);
        let w_183 = w_4 * self.g;
        let w_162 = self.k_10 * (w_110 * w_110 + w_112 * w_112);
        let w_163 = S::from_f64(0.0015) * (w_103 * w_103 + w_101 * w_101);
        let mass_q1_q1 = self.k_12 + w_159 + self.m6 * (w_94 * w_94 + w_95 * w_95)
            + w_160 + w_161 + w_162 + w_163 + S::from_f64(0.65) * sin_q2_squared
            + w_78 * w_78 * self.k_7 + S::from_f64(0.1) * w * w
            + S::from_f64(0.3) * w_4_squared + w_114 * w_114 * self.k_8;
        let w_195 = w * self.g;
        let w_196 = q2_dot
            * (tau2 - w_147 + cos_q3 * w_195 * self.k_44 + sin_q2 * self.k_45);
        let w_166 = S::from_f64(0.0015) * (w_103 * w_135 - w_101 * w_136);
        let mass_q2_q1 = w_165 + self.k_9 * (w_108 * w_140 - w_105 * w_139)
            - self.k_10 * (w_110 * w_142 + w_112 * w_144) + w_166
            - self.m6 * (w_94 * w_131 + w_95 * w_132);
        let k_q2_q1 = mass_q2_q1 - mass_q5_q1 * l_q2_q5 - mass_q4_q1 * l_q2_q4;
        let w_180 = S::from_f64(0.0015) * (w_135 * w_135 + w_136 * w_136);
        let pivot_q1 = mass_q1_q1 - mass_q5_q1 * l_q1_q5 - mass_q4_q1 * l_q1_q4;
        let inverse_q1 = S::from_f64(1.0) / pivot_q1;
        let l_q2_q1 = inverse_q1 * k_q2_q1;
        let rhs_q2 = w_157 - rhs_q5 * l_q2_q5 - rhs_q4 * l_q2_q4 - l_q2_q1 * rhs_q1;
        let tau3 = self.tau3.or(-S::from_f64(20.0));
        let w_169 = sin_q4 * (self.d4 + w_127);
        let w_173 = sin_q4 * (w_127 + self.k_17);
        let w_170 = cos_q4 * (self.d6 + self.d4 * cos_q5);
        let w_171 = cos_q6 * w_169 + sin_q6 * w_170;
        let w_172 = sin_q6 * w_169 - cos_q6 * w_170;
        let w_174 = cos_q4 * (self.d6 + cos_q5 * self.k_17);
        let mass_q3_q1 = w_166 + w_177 + self.k_10 * (w_112 * w_174 - w_110 * w_173)
            - self.m6 * (w_94 * w_171 + w_95 * w_172) - cos_q4 * w_108 * self.k_19;
        let mass_q3_q3 = w_180 + w_181 + self.k_23
            + self.m6 * (w_171 * w_171 + w_172 * w_172)
            + self.k_10 * (w_173 * w_173 + w_174 * w_174)
            + sin_q5_squared * cos_q4 * cos_q4 * self.k_24;
        let w_175 = self.c * q3_dot;
        let w_176 = tau3 - w_137 - w_146 + w_167 + w_168
            + self.m6 * (w_171 * w_61 + w_172 * w_62)
            + self.k_10 * (w_173 * w_67 - w_174 * w_63) - w_175 + self.k_21 * w_152
            - w_155 * self.k_41;
        let mass_q5_q3 = cos_q4 * (self.k_31 + cos_q5 * self.k_30);
        let l_q3_q5 = mass_q5_q3 * self.inverse_q5;
        let minus_l_q3_q4 = minus_mass_q4_q3 * inverse_q4;
        let k_q3_q1 = mass_q3_q1 - mass_q5_q1 * l_q3_q5 + mass_q4_q1 * minus_l_q3_q4;
        let l_q3_q1 = inverse_q1 * k_q3_q1;
        let w_178 = self.k_9 * (w_139 * w_139 + w_140 * w_140);
        let w_182 = cos_q4 * (sin_q5 * w_126 * self.k_20 - w_140 * self.k_19);
        let mass_q3_q2 = w_180 + w_181 + S::from_f64(0.316) + w_182
            + self.m6 * (w_131 * w_171 + w_132 * w_172)
            + self.k_10 * (w_142 * w_173 - w_144 * w_174) + w_150 * self.k_21
            + w_154 * self.k_22 - sin_q4 * w_139 * self.k_19;
        let w_179 = self.k_10 * (w_142 * w_142 + w_144 * w_144);
        let mass_q2_q2 = self.k_16 + self.m6 * (w_131 * w_131 + w_132 * w_132) + w_178
            + w_179 + w_180 + cos_q3 * cos_q3 * self.k_14 + self.k_11 * w_126 * w_126
            + self.k_8 * w_150 * w_150 + w_154 * w_154 * self.k_15 + w_181;
        let k_q3_q2 = mass_q3_q2 - mass_q5_q2 * l_q3_q5 + mass_q4_q2 * minus_l_q3_q4
            - k_q2_q1 * l_q3_q1;
        let pivot_q2 = mass_q2_q2 - mass_q5_q2 * l_q2_q5 - mass_q4_q2 * l_q2_q4
            - k_q2_q1 * l_q2_q1;
        let inverse_q2 = S::from_f64(1.0) / pivot_q2;
        let l_q3_q2 = inverse_q2 * k_q3_q2;
        let rhs_q3 = w_176 - rhs_q5 * l_q3_q5 + rhs_q4 * minus_l_q3_q4 - l_q3_q1 * rhs_q1
            - l_q3_q2 * rhs_q2;
        let pivot_q3 = mass_q3_q3 - mass_q5_q3 * l_q3_q5
            - minus_mass_q4_q3 * minus_l_q3_q4 - k_q3_q1 * l_q3_q1 - k_q3_q2 * l_q3_q2;
        let tau6 = self.tau6.or(S::from_f64(0.0));
        let w_197 = S::from_f64(0.025)
            * (q6_dot * (tau6 * S::from_f64(40.0) - self.c * q6_dot)
                + q4_dot * (tau4 * S::from_f64(40.0) - self.c * q4_dot)
                + q5_dot * (tau5 * S::from_f64(40.0) - self.c * q5_dot));
        let mass_q6_q4 = cos_q5 * S::from_f64(0.002);
        let l_q6_q4 = mass_q6_q4 * inverse_q4;
        let minus_k_q6_q1 = w_99 * S::from_f64(0.002) + mass_q4_q1 * l_q6_q4;
        let minus_l_q6_q1 = inverse_q1 * minus_k_q6_q1;
        let k_q6_q2 = mass_q6_q2 - mass_q4_q2 * l_q6_q4 + k_q2_q1 * minus_l_q6_q1;
        let l_q6_q2 = inverse_q2 * k_q6_q2;
        let k_q6_q3 = mass_q6_q2 + minus_mass_q4_q3 * l_q6_q4 + k_q3_q1 * minus_l_q6_q1
            - k_q3_q2 * l_q6_q2;
        let inverse_q3 = S::from_f64(1.0) / pivot_q3;
        let l_q6_q3 = inverse_q3 * k_q6_q3;
        let pivot_q6 = S::from_f64(0.002) - mass_q6_q4 * l_q6_q4
            - minus_k_q6_q1 * minus_l_q6_q1 - k_q6_q2 * l_q6_q2 - k_q6_q3 * l_q6_q3;
        let q6_ddot = S::from_f64(1.0) / pivot_q6
            * (w_71 + tau6 - q6_dot * self.k_43 - rhs_q4 * l_q6_q4
                + minus_l_q6_q1 * rhs_q1 - l_q6_q2 * rhs_q2 - l_q6_q3 * rhs_q3);
        let q3_ddot = inverse_q3 * rhs_q3 - l_q6_q3 * q6_ddot;
        let q2_ddot = inverse_q2 * rhs_q2 - l_q3_q2 * q3_ddot - l_q6_q2 * q6_ddot;
        let q1_ddot = inverse_q1 * rhs_q1 - l_q2_q1 * q2_ddot - l_q3_q1 * q3_ddot
            + minus_l_q6_q1 * q6_ddot;
        let w_184 = self.d4 * w_6;
        let w_185 = self.a2 * q2_dot;
        let w_186 = w_184 - sin_q3 * w_185;
        let w_187 = sin_q4 * w_186;
        let w_191 = sin_q4 * w_188 + cos_q4 * w_186;
        let w_189 = cos_q4 * w_188;
        let w_200 = w_199 - w_129 * w_185 + cos_q5 * w_191;
        let w_203 = self.k_11 * (w_124 * w_185 + sin_q5 * w_191)
            * (cos_q5 * w_195 + w_98 * w_183);
        let w_190 = w_187 - w_189;
        let w_192 = self.k_48
            * (sin_q4 * (S::from_f64(10.0) * w_190 + self.k_6 * w_7)
                - cos_q4 * (self.k_6 * w_25 - S::from_f64(10.0) * w_191));
        let w_194 = w_183
            * (w_192 + (w_184 - w_153 * q2_dot) * self.k_47
                - sin_q4 * self.k_35 * (w_193 - S::from_f64(5.0) * w_190));
        let w_198 = w_189 - w_187 + w_193;
        let w_201 = sin_q5 * w_195 - cos_q4 * cos_q5 * w_183;
        let w_202 = (cos_q6 * w_198 - sin_q6 * w_200) * (sin_q6 * w_201 - w_102 * w_183)
            - (cos_q6 * w_201 + w_100 * w_183) * (sin_q6 * w_198 + cos_q6 * w_200);
        let w_204 = self.k_35 * w_201 * (w_199 - w_143 * q2_dot + w_111 * w_191);
        sim_kernel::Dynamics {
            accelerations: [
                q1_ddot,
                q2_ddot,
                q3_ddot,
                rhs_q4 * inverse_q4 - l_q1_q4 * q1_ddot - l_q2_q4 * q2_ddot
                    + minus_l_q3_q4 * q3_ddot - l_q6_q4 * q6_ddot,
                rhs_q5 * self.inverse_q5 - l_q1_q5 * q1_ddot - l_q2_q5 * q2_ddot
                    - l_q3_q5 * q3_ddot,
                q6_ddot,
            ],
            multipliers: [],
            power: w_194 + w_196 + w_197 + self.m6 * w_202 + w_203
                + q1_dot * (tau1 - q1_dot * self.c) + q3_dot * (tau3 - w_175)
                + w_195 * (S::from_f64(3.0) * w_6 + w_149 * q2_dot) * self.k_46 - w_204,
            refused: sim_kernel::pivot_is_refused(self.mass_q5_q5, self.mass_q5_q5)
                | sim_kernel::pivot_is_refused(mass_q4_q4, mass_q4_q4)
                | sim_kernel::pivot_is_refused(pivot_q1, mass_q1_q1)
                | sim_kernel::pivot_is_refused(pivot_q2, mass_q2_q2)
                | sim_kernel::pivot_is_refused(pivot_q3, mass_q3_q3)
                | sim_kernel::pivot_is_refused(pivot_q6, S::from_f64(0.002)),
        }
    }
    /// Inverse dynamics `T_q' (M x'' - F)`, 6: the forces along the coordinates that must be added for these accelerations where there are no constraints, joules per unit of each coordinate.
    ///
    /// Operations: 205 additions, 248 multiplications, 5 sine-cosine pairs.
    #[inline]
    pub fn inverse_dynamics(
        &self,
        t: S,
        q: &[S; 6],
        qd: &[S; 6],
        qdd: &[S; 6],
    ) -> [S; 6] {
        let [_, q2, q3, q4, q5, q6] = *q;
        let [q1_dot, q2_dot, q3_dot, q4_dot, q5_dot, q6_dot] = *qd;
        let [q1_ddot, q2_ddot, q3_ddot, q4_ddot, q5_ddot, q6_ddot] = *qdd;
        let (
            [sin_q4,
            sin_q5,
            sin_q2,
            sin_q3,
            sin_q6,
            ],
            [cos_q4,
            cos_q5,
            cos_q2,
            cos_q3,
            cos_q6,
            ],
        ) = S::sin_cos_each([q4, q5, q2, q3, q6]);
        let w = q1_dot * q2_dot;
        let w_2 = cos_q2 * w;
        let w_11 = sin_q2 * w;
        let w_3 = sin_q2 * q1_ddot;
        let w_4 = S::from_f64(2.0) * w_2 + w_3;
        let w_5 = sin_q2 * cos_q3 + cos_q2 * sin_q3;
        let w_6 = w_5 * q1_dot;
        let w_7 = q2_dot + q3_dot;
        let w_8 = q3_dot + w_7;
        let w_9 = w_3 + w_2;
        let w_10 = sin_q3 * w_9;
        let w_30 = cos_q3 * w_9;
        let w_12 = cos_q2 * q1_ddot;
        let w_13 = w_11 - w_12;
        let w_14 = cos_q3 * w_13;
        let w_29 = sin_q3 * w_13;
        let w_15 = w_6 * w_8 + w_10 + w_14;
        let w_36 = q3_dot * w_6 + w_10 + w_14;
        let w_16 = self.a1 * q1_ddot + self.a2 * w_4 - self.d4 * w_15;
        let w_17 = cos_q4 * w_16;
        let w_18 = q4_dot - w_6;
        let w_19 = cos_q5 * w_18;
        let w_20 = cos_q2 * cos_q3 - sin_q2 * sin_q3;
        let w_21 = w_20 * q1_dot;
        let w_86 = S::from_f64(3.0) * (w_21 * w_8 - w_29 + w_30) + self.k_3 * q1_ddot
            + self.k_4 * w_4 - self.k_5 * w_15;
        let w_85 = self.k * q1_ddot + self.k_2 * w_4;
        let w_22 = cos_q4 * w_21 - sin_q4 * w_7;
        let w_23 = sin_q5 * w_22;
        let w_24 = w_19 - w_23;
        let w_91 = w_19 - w_23 + q6_dot;
        let w_25 = cos_q4 * w_7;
        let w_26 = sin_q4 * w_21;
        let w_27 = w_25 + w_26 + q5_dot;
        let w_33 = w_25 + w_26;
        let w_28 = q3_dot * w_21;
        let w_31 = w_28 - w_29 + w_30 - q4_ddot;
        let w_32 = sin_q5 * w_31;
        let w_99 = cos_q5 * w_31;
        let w_34 = q2_ddot + q3_ddot;
        let w_35 = sin_q4 * w_34;
        let w_37 = cos_q4 * w_36;
        let w_38 = q4_dot * w_33 + w_35 + w_37;
        let w_39 = cos_q5 * w_38;
        let w_40 = self.d6 * (w_24 * (q5_dot + w_27) - w_32 - w_39);
        let w_90 = q5_dot * w_24 - w_32 - w_39;
        let q1_dot_squared = q1_dot * q1_dot;
        let w_41 = self.a2 * (q2_dot * q2_dot + sin_q2 * sin_q2 * q1_dot_squared)
            + self.a1 * sin_q2 * q1_dot_squared - cos_q2 * self.g;
        let w_45 = cos_q2 * q1_dot_squared;
        let w_42 = cos_q3 * w_41;
        let w_54 = sin_q3 * w_41;
        let w_43 = w_21 * w_6;
        let w_44 = q2_ddot + q3_ddot + w_43;
        let w_46 = sin_q2 * w_45;
        let w_47 = w_46 - q2_ddot;
        let w_48 = sin_q2 * self.g + self.a1 * w_45 + self.a2 * w_47;
        let w_121 = self.k_38 * (sin_q2 * self.k_36 + self.k * w_45 + self.k_2 * w_47);
        let w_49 = sin_q3 * w_48;
        let w_55 = cos_q3 * w_48;
        let w_50 = w_42 + self.d4 * w_44 + w_49;
        let w_58 = sin_q4 * w_16 + cos_q4 * w_50;
        let w_51 = sin_q4 * w_50;
        let w_52 = w_17 + w_40 - w_51;
        let w_70 = w_17 - w_51;
        let w_73 = w_40 + S::from_f64(5.0) * w_70;
        let w_7_squared = w_7 * w_7;
        let w_118 = self.m3
            * (S::from_f64(3.0) * (w_7_squared + w_6 * w_6)
                + S::from_f64(100.0) * (w_42 + w_49) + self.k_5 * w_44);
        let w_53 = w_7_squared + w_21 * w_21;
        let w_56 = self.d4 * w_53 - w_54 + w_55;
        let w_112 = w_55 - w_54;
        let w_57 = sin_q5 * w_56;
        let w_76 = cos_q5 * w_56;
        let w_59 = cos_q5 * w_58;
        let w_60 = q4_dot * w_22;
        let w_61 = sin_q5 * w_18 + cos_q5 * w_22;
        let w_62 = w_61 * w_24;
        let w_63 = cos_q4 * w_34;
        let w_64 = sin_q4 * w_36;
        let w_65 = self.d6 * (w_60 - w_62 + w_63 - w_64 + q5_ddot);
        let w_66 = w_57 + w_59 + w_65;
        let w_80 = self.m5 * (S::from_f64(5.0) * (w_57 + w_59) + w_65);
        let w_67 = sin_q6 * w_52 + cos_q6 * w_66;
        let w_68 = cos_q6 * w_52 - sin_q6 * w_66;
        let w_69 = sin_q6 * w_67 + cos_q6 * w_68;
        let w_79 = cos_q6 * w_67 - sin_q6 * w_68;
        let w_71 = q4_dot - w_18;
        let w_72 = S::from_f64(10.0) * w_70 + self.k_6 * (w_33 * w_71 + w_35 + w_37);
        let w_82 = self.k_6 * (w_22 * w_71 + w_63 - w_64) - S::from_f64(10.0) * w_58;
        let w_77 = sin_q5 * w_58;
        let w_89 = w_18 * S::from_f64(80.0);
        let w_74 = self.k_49 * w_69 + self.m4 * w_72 + self.k_50 * w_73;
        let w_75 = self.d6 * (w_27 * w_27 + w_61 * w_61);
        let w_78 = self.m5 * (w_75 + S::from_f64(5.0) * (w_76 - w_77))
            + self.k_53 * (w_75 - w_77 + w_76);
        let w_81 = self.k_53 * w_79 + w_80;
        let w_103 = w_80 + w_79 * self.k_57;
        let w_83 = S::from_f64(2.0) * (sin_q5 * w_78 - cos_q5 * w_81) + self.m4 * w_82;
        let w_84 = cos_q4 * w_74 - sin_q4 * w_83;
        let w_87 = sin_q2
            * ((S::from_f64(40.0) * w_84 + w_85 * self.k_54 + w_86 * self.k_55)
                * self.k_61
                + S::from_f64(0.05)
                    * (w_2 * S::from_f64(29.0) + w_3 * S::from_f64(15.0)));
        let w_119 = cos_q4 * w_83 + sin_q4 * w_74;
        let w_88 = self.m3 * w_86;
        let w_92 = cos_q6 * w_27 + sin_q6 * w_61;
        let w_93 = w_60 + w_63 - w_64 + q5_ddot;
        let w_94 = w_91 * w_92
            + S::from_f64(3.0) * (q6_dot * w_92 - cos_q6 * w_90 + sin_q6 * w_93);
        let w_95 = cos_q6 * w_61 - sin_q6 * w_27;
        let w_96 = w_95 * w_91
            + S::from_f64(3.0) * (q6_dot * w_95 + cos_q6 * w_93 + sin_q6 * w_90);
        let w_97 = S::from_f64(14.0) * w_90 + S::from_f64(2.0) * w_27 * w_24
            + (self.m5 * w_73 + w_69 * self.k_57) * self.k_58 - cos_q6 * w_94
            + sin_q6 * w_96;
        let w_104 = sin_q6 * w_94;
        let w_105 = cos_q6 * w_96;
        let w_106 = S::from_f64(132.0) * (w_60 + w_63 - w_64) - w_22 * w_89
            - w_62 * S::from_f64(4.0) + q5_ddot * S::from_f64(12.0) + self.k_58 * w_103
            + w_104 + w_105 + w_82 * self.k_59;
        let w_98 = q5_dot * w_61;
        let w_100 = sin_q5 * w_38;
        let w_101 = S::from_f64(7.0) * (w_98 + w_99 - w_100) - w_61 * w_27
            - S::from_f64(2.0) * q6_ddot;
        let w_102 = w_38 * S::from_f64(120.0) - w_33 * w_89 + w_72 * self.k_59
            - cos_q5 * w_97 - sin_q5 * S::from_f64(2.0) * w_101;
        let w_107 = w_20 * S::from_f64(0.0005)
            * (w_36 * S::from_f64(480.0) + w_7 * w_6 * S::from_f64(340.0)
                - (w_88 + w_84 * S::from_f64(50.0)) * self.k_60 + cos_q4 * w_102
                - sin_q4 * w_106);
        let w_116 = S::from_f64(0.0005) * (sin_q4 * w_102 + cos_q4 * w_106);
        let w_108 = sin_q5 * w_97;
        let w_109 = cos_q5 * w_101;
        let w_110 = w_5 * S::from_f64(0.0001)
            * (S::from_f64(1000.0) * (w_28 - w_29 + w_30)
                + S::from_f64(100.0) * w_21 * w_7 - S::from_f64(200.0) * q4_ddot
                + self.k_52 * w_86 - S::from_f64(5.0) * w_108
                + S::from_f64(10.0) * w_109);
        let w_111 = S::from_f64(0.16) * w_43;
        let w_113 = self.k_5 * w_53 + S::from_f64(3.0) * (w_43 - w_34)
            + S::from_f64(100.0) * w_112;
        let w_114 = (self.m3 * w_113
            + self.k_51
                * (w_53 * self.k_37 - self.k_6 * (w_33 * w_33 + w_22 * w_22)
                    + S::from_f64(10.0) * w_112)) * self.k_66;
        let w_115 = cos_q3 * (self.k_65 * (sin_q5 * w_81 + cos_q5 * w_78) + w_114);
        let w_117 = self.k_21 * w_113;
        let w_120 = (w_118 - S::from_f64(50.0) * w_119) * self.k_64;
        [
            q1_dot * self.c - self.tau1.or(S::from_f64(0.0)) + w_87 + q1_ddot * self.k_63
                + (w_85 * self.k_56 + w_88 + S::from_f64(10.0) * w_84) * self.k_62
                - w_107 + w_110
                - cos_q2 * S::from_f64(0.05)
                    * (S::from_f64(3.0) * w_11 - S::from_f64(2.0) * w_12),
            w_111 - self.tau2.or(-S::from_f64(60.0)) - S::from_f64(0.65) * w_46
                + self.c * q2_dot - w_115 + w_116 + q2_ddot * S::from_f64(1.05)
                + q3_ddot * S::from_f64(0.25) - w_117 + w_120
                - sin_q3 * (w_118 - S::from_f64(10.0) * w_119) * self.k_66 - w_121,
            w_111 - self.tau3.or(-S::from_f64(20.0)) + self.c * q3_dot + w_116 - w_117
                + w_120 + w_34 * S::from_f64(0.25),
            q4_dot * self.k_43 - self.tau4.or(S::from_f64(0.0))
                + S::from_f64(0.02) * (w_29 - w_28 - w_30 + q4_ddot)
                + S::from_f64(0.0005) * w_108 - S::from_f64(0.001) * w_109,
            q5_dot * self.k_43 - self.tau5.or(S::from_f64(0.0))
                - S::from_f64(0.002) * w_62 + S::from_f64(0.006) * w_93
                + S::from_f64(0.0005) * (w_104 + w_105) + w_103 * self.k_67,
            q6_dot * self.k_43 - self.tau6.or(S::from_f64(0.0))
                + S::from_f64(0.002) * (q6_ddot - w_98 - w_99 + w_100),
        ]
    }
}
#[allow(non_snake_case, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for RobotArm<S> {
    type Q = [S; 6];
    type L = [S; 0];
    type Z = [S; 6];
    type QQ = [[S; 6]; 6];
    type LQ = [[S; 6]; 0];
    type LL = [[S; 0]; 0];
    type ZZ = [[S; 6]; 6];
    type Entries = [S; 0];
    type Envelope = [S; 0];
    type Parameters = [S; 13];
    type Outputs = [S; 4];
    type OutputRates = [S; 4];
    type Events = [S; 0];
    type EventValues = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 36];
    type QP = [[S; 13]; 6];
    type LP = [[S; 13]; 0];
    type Inputs = [sim_kernel::Input<S>; 6];
    type Prepared = RobotArmPrepared<S>;
    type On<T: sim_kernel::Scalar> = RobotArm<T>;
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "robot-arm",
        type_name: "RobotArm",
        docs: "A six-axis arm with a spherical wrist, let swing from rest under the torques of its drives.",
        declaration: "/// A six-axis arm with a spherical wrist, let swing from rest under the torques of its drives.\npub RobotArm;\n\ncoordinates {\n    /// Waist, about the vertical.\n    q1 [rad];\n    /// Shoulder.\n    q2 [rad];\n    /// Elbow.\n    q3 [rad];\n    /// Roll of the forearm.\n    q4 [rad];\n    /// Bend of the wrist.\n    q5 [rad];\n    /// Turn of the flange.\n    q6 [rad];\n}\n\nparameters {\n    /// Height of the shoulder over the base.\n    h [m] = 0.4;\n    /// Shoulder ahead of the waist's axis.\n    a1 [m] = 0.15;\n    /// Length of the upper arm.\n    a2 [m] = 0.6;\n    /// Elbow to wrist.\n    d4 [m] = 0.55;\n    /// Wrist to flange.\n    d6 [m] = 0.1;\n    m1 [kg] = 30;\n    m2 [kg] = 18;\n    m3 [kg] = 12;\n    m4 [kg] = 5;\n    m5 [kg] = 2.5;\n    m6 [kg] = 1;\n    g [m/s^2] = 9.81;\n    /// Viscous friction of the first three drives; those of the wrist have a fortieth of it.\n    c [N*m*s] = 0.8;\n}\n\ninputs { tau1 [N*m] = 0; tau2 [N*m] = -60; tau3 [N*m] = -20; tau4 [N*m] = 0; tau5 [N*m] = 0; tau6 [N*m] = 0; }\n\nlet R1 = rotation(z, q1);\nlet R2 = R1*rotation(y, q2);\nlet R3 = R2*rotation(y, q3);\nlet R4 = R3*rotation(x, q4);\nlet R5 = R4*rotation(y, q5);\nlet R6 = R5*rotation(x, q6);\nlet shoulder = R1*[a1, 0, h];\nlet elbow = shoulder + R2*[0, 0, a2];\nlet wrist = elbow + R3*[d4, 0, 0];\nlet flange = wrist + R5*[d6, 0, 0];\n\nbodies {\n    waist: mass m1 at R1*[0.4*a1, 0, 0.6*h], inertia [0.9 [kg*m^2], 0.8 [kg*m^2], 0.7 [kg*m^2]], attitude R1;\n    upper_arm: mass m2 at shoulder + R2*[0, 0, 0.45*a2], inertia [0.75 [kg*m^2], 0.8 [kg*m^2], 0.1 [kg*m^2]], attitude R2;\n    forearm: mass m3 at elbow + R3*[0.2*d4, 0, 0.03 [m]], inertia [0.08 [kg*m^2], 0.25 [kg*m^2], 0.24 [kg*m^2]], attitude R3;\n    roll: mass m4 at wrist + R4*[-0.3*d4, 0, 0], inertia [0.02 [kg*m^2], 0.06 [kg*m^2], 0.06 [kg*m^2]], attitude R4;\n    bend: mass m5 at wrist + R5*[0.2*d6, 0, 0], inertia [0.005 [kg*m^2], 0.006 [kg*m^2], 0.007 [kg*m^2]], attitude R5;\n    tool: mass m6 at flange, inertia [0.002 [kg*m^2], 0.0015 [kg*m^2], 0.0015 [kg*m^2]], attitude R6;\n}\n\nloads {\n    gravity [0, 0, -g];\n    torque tau1 - c*dot(q1) on q1;\n    torque tau2 - c*dot(q2) on q2;\n    torque tau3 - c*dot(q3) on q3;\n    torque tau4 - c/40*dot(q4) on q4;\n    torque tau5 - c/40*dot(q5) on q5;\n    torque tau6 - c/40*dot(q6) on q6;\n}\n\ninitial { q1 = 0; q2 = 20 [deg]; q3 = -30 [deg]; q4 = 10 [deg]; q5 = 40 [deg]; q6 = 0; dot(q1) = 0.5; }\n\noutputs {\n    flange_position \"Position of the flange\" {\n        x [m] = flange.x;\n        y [m] = flange.y;\n        height [m] = flange.z;\n    }\n    /// speed of the flange\n    flange_speed [m/s] = norm(dot(flange));\n}\n\ndrawing {\n    ground [0, 0, 0];\n    line [0, 0, 0], R1*[0, 0, h], shoulder;\n    line shoulder, elbow;\n    line elbow, wrist;\n    line wrist, flange;\n    curve flange, flange + R6*[0, 0.05 [m], 0];\n}\n\nkernels { inverse_dynamics; }\n",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "q1",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Waist, about the vertical.",
                },
                speed: sim_kernel::Quantity {
                    name: "q1_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "q1_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: true,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "q2",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Shoulder.",
                },
                speed: sim_kernel::Quantity {
                    name: "q2_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "q2_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "q3",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Elbow.",
                },
                speed: sim_kernel::Quantity {
                    name: "q3_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "q3_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "q4",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Roll of the forearm.",
                },
                speed: sim_kernel::Quantity {
                    name: "q4_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "q4_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "q5",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Bend of the wrist.",
                },
                speed: sim_kernel::Quantity {
                    name: "q5_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "q5_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "q6",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Turn of the flange.",
                },
                speed: sim_kernel::Quantity {
                    name: "q6_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "q6_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: false,
            },
        ],
        parameters: &[
            sim_kernel::Quantity {
                name: "h",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Height of the shoulder over the base.",
            },
            sim_kernel::Quantity {
                name: "a1",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Shoulder ahead of the waist's axis.",
            },
            sim_kernel::Quantity {
                name: "a2",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Length of the upper arm.",
            },
            sim_kernel::Quantity {
                name: "d4",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Elbow to wrist.",
            },
            sim_kernel::Quantity {
                name: "d6",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Wrist to flange.",
            },
            sim_kernel::Quantity {
                name: "m1",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "m2",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "m3",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "m4",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "m5",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "m6",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "g",
                unit: "m/s^2",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "c",
                unit: "N*m*s",
                factor: 1f64,
                is_length: false,
                docs: "Viscous friction of the first three drives; those of the wrist have a fortieth of it.",
            },
        ],
        inputs: &[
            sim_kernel::Quantity {
                name: "tau1",
                unit: "N*m",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "tau2",
                unit: "N*m",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "tau3",
                unit: "N*m",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "tau4",
                unit: "N*m",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "tau5",
                unit: "N*m",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "tau6",
                unit: "N*m",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
        ],
        constraints: &[],
        speed_constraints: &[],
        norm_constraints: &[],
        sparsity: &[],
        conditionals: &[],
        events: &[],
        outputs: &[
            sim_kernel::Quantity {
                name: "x",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "y",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "height",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "flange_speed",
                unit: "m/s",
                factor: 1f64,
                is_length: false,
                docs: "speed of the flange",
            },
        ],
        rated_outputs: &[0, 1, 2, 3],
        figures: &[
            sim_kernel::Figure {
                name: "flange_position",
                title: "Position of the flange",
                len: 3,
            },
            sim_kernel::Figure {
                name: "flange_speed",
                title: "speed of the flange",
                len: 1,
            },
        ],
        optional_kernels: &["inverse_dynamics"],
        dimension: 3,
        drawing: &[
            sim_kernel::Shape::Ground(1),
            sim_kernel::Shape::Line(3),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Curve(2),
        ],
    };
    fn defaults() -> Self {
        Self {
            h: S::from_f64(0.4f64),
            a1: S::from_f64(0.15f64),
            a2: S::from_f64(0.6f64),
            d4: S::from_f64(0.55f64),
            d6: S::from_f64(0.1f64),
            m1: S::from_f64(30f64),
            m2: S::from_f64(18f64),
            m3: S::from_f64(12f64),
            m4: S::from_f64(5f64),
            m5: S::from_f64(2.5f64),
            m6: S::from_f64(1f64),
            g: S::from_f64(9.81f64),
            c: S::from_f64(0.8f64),
            tau1: sim_kernel::Input::Declared,
            tau2: sim_kernel::Input::Declared,
            tau3: sim_kernel::Input::Declared,
            tau4: sim_kernel::Input::Declared,
            tau5: sim_kernel::Input::Declared,
            tau6: sim_kernel::Input::Declared,
        }
    }
    fn parameters(&self) -> [S; 13] {
        [
            self.h,
            self.a1,
            self.a2,
            self.d4,
            self.d6,
            self.m1,
            self.m2,
            self.m3,
            self.m4,
            self.m5,
            self.m6,
            self.g,
            self.c,
        ]
    }
    fn with_parameters(&self, parameters: [S; 13]) -> Self {
        Self {
            h: parameters[0],
            a1: parameters[1],
            a2: parameters[2],
            d4: parameters[3],
            d6: parameters[4],
            m1: parameters[5],
            m2: parameters[6],
            m3: parameters[7],
            m4: parameters[8],
            m5: parameters[9],
            m6: parameters[10],
            g: parameters[11],
            c: parameters[12],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> RobotArm<T> {
        RobotArm {
            h: convert(self.h),
            a1: convert(self.a1),
            a2: convert(self.a2),
            d4: convert(self.d4),
            d6: convert(self.d6),
            m1: convert(self.m1),
            m2: convert(self.m2),
            m3: convert(self.m3),
            m4: convert(self.m4),
            m5: convert(self.m5),
            m6: convert(self.m6),
            g: convert(self.g),
            c: convert(self.c),
            tau1: self.tau1.map(&convert),
            tau2: self.tau2.map(&convert),
            tau3: self.tau3.map(&convert),
            tau4: self.tau4.map(&convert),
            tau5: self.tau5.map(&convert),
            tau6: self.tau6.map(&convert),
        }
    }
    fn inputs(&self) -> [sim_kernel::Input<S>; 6] {
        [self.tau1, self.tau2, self.tau3, self.tau4, self.tau5, self.tau6]
    }
    fn with_inputs(&self, inputs: [sim_kernel::Input<S>; 6]) -> Self {
        Self {
            tau1: inputs[0],
            tau2: inputs[1],
            tau3: inputs[2],
            tau4: inputs[3],
            tau5: inputs[4],
            tau6: inputs[5],
            ..*self
        }
    }
    fn set_inputs(prepared: &mut Self::Prepared, inputs: [sim_kernel::Input<S>; 6]) {
        prepared.tau1 = inputs[0];
        prepared.tau2 = inputs[1];
        prepared.tau3 = inputs[2];
        prepared.tau4 = inputs[3];
        prepared.tau5 = inputs[4];
        prepared.tau6 = inputs[5];
    }
    #[inline(always)]
    fn prepare(&self) -> RobotArmPrepared<S> {
        self.prepare()
    }
    #[inline(always)]
    fn prepared_dynamics(
        prepared: &Self::Prepared,
        t: S,
        q: &[S; 6],
        qd: &[S; 6],
    ) -> sim_kernel::Dynamics<S, [S; 6], [S; 0]> {
        prepared.dynamics(t, q, qd)
    }
    #[inline(always)]
    fn inverse_dynamics(&self, t: S, q: &[S; 6], qd: &[S; 6], qdd: &[S; 6]) -> [S; 6] {
        self.prepare().inverse_dynamics(t, q, qd, qdd)
    }
    #[inline(always)]
    fn mass_matrix(&self, t: S, q: &[S; 6]) -> [[S; 6]; 6] {
        self.mass_matrix(t, q)
    }
    #[inline(always)]
    fn convective_forces(&self, t: S, q: &[S; 6], qd: &[S; 6]) -> [S; 6] {
        self.convective_forces(t, q, qd)
    }
    #[inline(always)]
    fn generalized_forces(&self, t: S, q: &[S; 6], qd: &[S; 6]) -> [S; 6] {
        self.generalized_forces(t, q, qd)
    }
    #[inline(always)]
    fn constraints(&self, t: S, q: &[S; 6]) -> [S; 0] {
        self.constraints(t, q)
    }
    #[inline(always)]
    fn constraint_magnitudes(&self, t: S, q: &[S; 6]) -> [S; 0] {
        self.constraint_magnitudes(t, q)
    }
    #[inline(always)]
    fn constraint_jacobian(&self, t: S, q: &[S; 6]) -> [[S; 6]; 0] {
        self.constraint_jacobian(t, q)
    }
    #[inline(always)]
    fn constraint_time_derivative(&self, t: S, q: &[S; 6]) -> [S; 0] {
        self.constraint_time_derivative(t, q)
    }
    #[inline(always)]
    fn constraint_convective(&self, t: S, q: &[S; 6], qd: &[S; 6]) -> [S; 0] {
        self.constraint_convective(t, q, qd)
    }
    #[inline(always)]
    fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 6],
    ) -> sim_kernel::ConstraintLinearization<[S; 0], [[S; 6]; 0]> {
        self.constraint_linearization(t, q)
    }
    #[inline(always)]
    fn kinetic_energy(&self, t: S, q: &[S; 6], qd: &[S; 6]) -> S {
        self.kinetic_energy(t, q, qd)
    }
    #[inline(always)]
    fn power(&self, t: S, q: &[S; 6], qd: &[S; 6], qdd: &[S; 6], lambda: &[S; 0]) -> S {
        self.power(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn outputs(
        &self,
        t: S,
        q: &[S; 6],
        qd: &[S; 6],
        qdd: &[S; 6],
        lambda: &[S; 0],
    ) -> [S; 4] {
        self.outputs(t, q, qd, qdd, lambda).into()
    }
    #[inline(always)]
    fn output_rates(&self, t: S, q: &[S; 6], qd: &[S; 6], qdd: &[S; 6]) -> [S; 4] {
        self.output_rates(t, q, qd, qdd).into()
    }
    #[inline(always)]
    fn events(
        &self,
        t: S,
        q: &[S; 6],
        qd: &[S; 6],
        qdd: &[S; 6],
        lambda: &[S; 0],
    ) -> [S; 0] {
        self.events(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn drawing(&self, t: S, q: &[S; 6]) -> [S; 36] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 6]> {
        self.initial()
    }
    fn held_inputs(&self, t: S, q: &[S; 6]) -> Self::Inputs {
        self.input_values(t, q).map(sim_kernel::Input::Held)
    }
}
