// The whole interpolator: commands in, step and direction signals out.
//
//   command -> command_decoder -> command_fifo -> engine -> step_dir, one an axis
//                                       pulse_source ^
//
// Commands come by a ready/valid handshake, are checked and turned into first register contents,
// and wait in the queue as such: so one curve follows the other without a gap, as long as the queue
// does not run empty. A command that cannot be done is refused with its reason in o_error, before
// it moves anything; those before it are carried out, and no other is taken until i_clear.
//
// One engine runs at a time. Every i_period clocks (of its command) the pulse source begins a
// cycle, but not while an output stage still has a pulse waiting: the stages' times are kept, and no
// pulse is lost, by making the source wait. From the last cycle of a curve to the first of the next
// it is one period, too.
//
// A pulse of an engine is in o_pulse a clock later, and at o_step two clocks after that if nothing
// holds it up.
module interpolator #(
    parameter N         = 24,
    // axes of lines by digital integration and rate multiplication; other curves have two
    parameter AXES      = 2,
    // bits of the output stages' times, and of a period
    parameter T         = 16,
    parameter P         = 24,
    parameter LOG_DEPTH = 2,
    // bits of a coordinate
    parameter W         = N < 32 ? N + 1 : 32
) (
    input  wire              i_clk,
    input  wire              i_rst,
    // a command, taken when ready; see command_decoder
    input  wire              i_valid,
    output wire              o_ready,
    input  wire [2:0]        i_curve,
    input  wire [2*W-1:0]    i_start,
    input  wire [AXES*W-1:0] i_end,
    input  wire              i_cw,
    input  wire [1:0]        i_preset,
    input  wire              i_normalize,
    input  wire [P-1:0]      i_period,
    // why the last command was refused, 0 if it was not; and that the reason was seen
    output wire [2:0]        o_error,
    input  wire              i_clear,
    // the drives' times, in clocks; see step_dir
    input  wire [T-1:0]      i_length,
    input  wire [T-1:0]      i_space,
    input  wire [T-1:0]      i_setup,
    input  wire [T-1:0]      i_hold,
    // to the drives
    output wire [AXES-1:0]   o_step,
    output wire [AXES-1:0]   o_dir,
    // all commands are carried out, to the last step
    output wire              o_done,
    // registers of its own
    output reg               o_running,
    output reg  [2:0]        o_curve,
    output reg  [P-1:0]      o_period,
    output reg  [AXES-1:0]   o_pulse,
    output reg  [AXES-1:0]   o_negative,
    // registers of pulse source, queue and output stages
    output wire              o_due,
    output wire [P-1:0]      o_count,
    output wire [LOG_DEPTH:0] o_fifo_write,
    output wire [LOG_DEPTH:0] o_fifo_read,
    output wire [AXES-1:0]   o_pending,
    output wire [AXES-1:0]   o_want,
    output wire [AXES-1:0]   o_turned,
    output wire [AXES*T-1:0] o_timer,
    output wire [AXES*T-1:0] o_guard,
    // registers of the decoder
    output wire [3:0]        o_decoder_state,
    output wire [2:0]        o_decoder_curve,
    output wire [P-1:0]      o_decoder_period,
    output wire [AXES*N-1:0] o_decoder_first,
    output wire [AXES-1:0]   o_decoder_negative,
    output wire [N-1:0]      o_decoder_jrx,
    output wire [N-1:0]      o_decoder_jry,
    output wire [N-1:0]      o_decoder_unit,
    output wire [N:0]        o_decoder_je,
    output wire [1:0]        o_decoder_quadrant,
    output wire [2:0]        o_decoder_crossings,
    output wire              o_decoder_cw,
    output wire [N+1:0]      o_decoder_jex,
    output wire [N+1:0]      o_decoder_jey,
    output wire [1:0]        o_decoder_preset,
    output wire              o_decoder_normalize,
    output wire [2*W-1:0]    o_decoder_start,
    output wire [AXES*W-1:0] o_decoder_end,
    output wire [1:0]        o_decoder_start_negative,
    output wire [6:0]        o_decoder_count,
    output wire [W-1:0]      o_decoder_bits_x,
    output wire [W-1:0]      o_decoder_bits_y,
    output wire [W:0]        o_decoder_high,
    output wire [W-1:0]      o_decoder_low,
    output wire [W+1:0]      o_decoder_turn,
    output wire              o_decoder_turn_rest,
    output wire [N+1:0]      o_decoder_root,
    output wire [N+1:0]      o_decoder_rest,
    // registers of dda_line
    output wire [AXES*N-1:0] o_dda_line_jv,
    output wire [AXES*N-1:0] o_dda_line_jr,
    output wire [N:0]        o_dda_line_je,
    output wire [AXES-1:0]   o_dda_line_negative,
    // registers of dda_arc
    output wire              o_dda_arc_beat,
    output wire [N-1:0]      o_dda_arc_unit,
    output wire [N-1:0]      o_dda_arc_jvx,
    output wire [N-1:0]      o_dda_arc_jvy,
    output wire [N-1:0]      o_dda_arc_jrx,
    output wire [N-1:0]      o_dda_arc_jry,
    output wire [N:0]        o_dda_arc_sumx,
    output wire [N:0]        o_dda_arc_sumy,
    output wire [1:0]        o_dda_arc_quadrant,
    output wire [2:0]        o_dda_arc_crossings,
    output wire              o_dda_arc_cw,
    output wire [N+1:0]      o_dda_arc_jex,
    output wire [N+1:0]      o_dda_arc_jey,
    output wire              o_dda_arc_last,
    output wire              o_dda_arc_towards_is_y,
    output wire              o_dda_arc_feeds_nx,
    output wire              o_dda_arc_feeds_ny,
    output wire              o_dda_arc_at_end_x,
    output wire              o_dda_arc_at_end_y,
    output wire              o_dda_arc_stands_x,
    output wire              o_dda_arc_stands_y,
    output wire              o_dda_arc_stepping_out,
    output wire              o_dda_arc_nx,
    output wire              o_dda_arc_ny,
    output wire              o_dda_arc_shrinks_x,
    output wire              o_dda_arc_shrinks_y,
    // registers of dda_centred_arc
    output wire [1:0]        o_dda_centred_arc_beat,
    output wire [N-1:0]      o_dda_centred_arc_unit,
    output wire [N-1:0]      o_dda_centred_arc_x,
    output wire [N-1:0]      o_dda_centred_arc_y,
    output wire [N-1:0]      o_dda_centred_arc_jrx,
    output wire [N-1:0]      o_dda_centred_arc_jry,
    output wire [N+1:0]      o_dda_centred_arc_sum,
    output wire [1:0]        o_dda_centred_arc_quadrant,
    output wire [2:0]        o_dda_centred_arc_crossings,
    output wire              o_dda_centred_arc_cw,
    output wire [N+1:0]      o_dda_centred_arc_jex,
    output wire [N+1:0]      o_dda_centred_arc_jey,
    output wire              o_dda_centred_arc_last,
    output wire              o_dda_centred_arc_towards_is_y,
    output wire              o_dda_centred_arc_feeds_nx,
    output wire              o_dda_centred_arc_feeds_ny,
    output wire              o_dda_centred_arc_at_end_x,
    output wire              o_dda_centred_arc_at_end_y,
    output wire              o_dda_centred_arc_stands_x,
    output wire              o_dda_centred_arc_stands_y,
    output wire              o_dda_centred_arc_stepping_out,
    output wire              o_dda_centred_arc_nx,
    output wire              o_dda_centred_arc_ny,
    output wire              o_dda_centred_arc_shrinks_x,
    output wire              o_dda_centred_arc_shrinks_y,
    // registers of ppc_line
    output wire [1:0]        o_ppc_line_rule,
    output wire              o_ppc_line_larger_is_y,
    output wire [1:0]        o_ppc_line_beat,
    output wire              o_ppc_line_fx,
    output wire [N:0]        o_ppc_line_f,
    output wire [N-1:0]      o_ppc_line_end_x,
    output wire [N-1:0]      o_ppc_line_end_y,
    output wire [N-1:0]      o_ppc_line_jex,
    output wire [N-1:0]      o_ppc_line_jey,
    output wire [N:0]        o_ppc_line_e,
    output wire [1:0]        o_ppc_line_negative,
    // registers of ppc_arc
    output wire [1:0]        o_ppc_arc_rule,
    output wire              o_ppc_arc_larger_is_y,
    output wire [1:0]        o_ppc_arc_beat,
    output wire              o_ppc_arc_fx,
    output wire [N+1:0]      o_ppc_arc_f,
    output wire [N-1:0]      o_ppc_arc_cx,
    output wire [N-1:0]      o_ppc_arc_cy,
    output wire [N+3:0]      o_ppc_arc_e,
    output wire [1:0]        o_ppc_arc_quadrant,
    output wire [2:0]        o_ppc_arc_crossings,
    output wire              o_ppc_arc_cw,
    output wire [N+1:0]      o_ppc_arc_jex,
    output wire [N+1:0]      o_ppc_arc_jey,
    output wire              o_ppc_arc_last,
    output wire              o_ppc_arc_towards_is_y,
    output wire              o_ppc_arc_feeds_nx,
    output wire              o_ppc_arc_feeds_ny,
    output wire              o_ppc_arc_at_end_x,
    output wire              o_ppc_arc_at_end_y,
    output wire              o_ppc_arc_stands_x,
    output wire              o_ppc_arc_stands_y,
    output wire              o_ppc_arc_stepping_out,
    output wire              o_ppc_arc_nx,
    output wire              o_ppc_arc_ny,
    output wire              o_ppc_arc_shrinks_x,
    output wire              o_ppc_arc_shrinks_y,
    // registers of brm_line
    output wire              o_brm_line_tg,
    output wire [N-1:0]      o_brm_line_divider,
    output wire [AXES*N-1:0] o_brm_line_value,
    output wire [N-1:0]      o_brm_line_stages,
    output wire              o_brm_line_overflow,
    output wire [AXES-1:0]   o_brm_line_negative
);
    localparam ENTRY = 3 + P + AXES*N + AXES + 3*N + (N+1) + 2 + 3 + 1 + 2*(N+2);

    // Decoder and queue.
    wire [2:0]        curve;
    wire [P-1:0]      period;
    wire [AXES*N-1:0] first;
    wire [AXES-1:0]   negative;
    wire [N-1:0]      jrx, jry, unit;
    wire [N:0]        je;
    wire [1:0]        quadrant;
    wire [2:0]        crossings;
    wire              cw;
    wire [N+1:0]      jex, jey;
    wire              decoded, has_room, has_entry, starts;

    command_decoder #(.N(N), .AXES(AXES), .P(P)) decoder (
        .i_clk(i_clk), .i_rst(i_rst), .i_valid(i_valid), .o_ready(o_ready), .i_curve(i_curve),
        .i_start(i_start), .i_end(i_end), .i_cw(i_cw), .i_preset(i_preset),
        .i_normalize(i_normalize), .i_period(i_period), .i_clear(i_clear), .o_error(o_error),
        .o_valid(decoded), .i_ready(has_room), .o_state(o_decoder_state),
        .o_curve(o_decoder_curve), .o_period(o_decoder_period), .o_first(o_decoder_first),
        .o_negative(o_decoder_negative), .o_jrx(o_decoder_jrx), .o_jry(o_decoder_jry),
        .o_unit(o_decoder_unit), .o_je(o_decoder_je), .o_quadrant(o_decoder_quadrant),
        .o_crossings(o_decoder_crossings), .o_cw(o_decoder_cw), .o_jex(o_decoder_jex),
        .o_jey(o_decoder_jey), .o_preset(o_decoder_preset), .o_normalize(o_decoder_normalize),
        .o_start(o_decoder_start), .o_end(o_decoder_end),
        .o_start_negative(o_decoder_start_negative), .o_count(o_decoder_count),
        .o_bits_x(o_decoder_bits_x), .o_bits_y(o_decoder_bits_y), .o_high(o_decoder_high),
        .o_low(o_decoder_low), .o_turn(o_decoder_turn), .o_turn_rest(o_decoder_turn_rest),
        .o_root(o_decoder_root), .o_rest(o_decoder_rest)
    );

    command_fifo #(.WIDTH(ENTRY), .LOG_DEPTH(LOG_DEPTH)) fifo (
        .i_clk(i_clk), .i_rst(i_rst), .i_valid(decoded), .o_ready(has_room), .o_valid(has_entry),
        .i_ready(starts),
        .i_data({o_decoder_curve, o_decoder_period, o_decoder_first, o_decoder_negative,
                 o_decoder_jrx, o_decoder_jry, o_decoder_unit, o_decoder_je, o_decoder_quadrant,
                 o_decoder_crossings, o_decoder_cw, o_decoder_jex, o_decoder_jey}),
        .o_data({curve, period, first, negative, jrx, jry, unit, je, quadrant, crossings, cw, jex,
                 jey}),
        .o_write(o_fifo_write), .o_read(o_fifo_read)
    );

    // Sequence: a curve starts when none runs. Its engine is loaded then, and runs from the next
    // clock on until it is done.
    wire [5:0] engine_done;
    wire       is_done = &engine_done;
    assign     starts  = has_entry & ~o_running;

    always @(posedge i_clk)
        if (i_rst) begin
            o_running <= 1'b0;
            o_curve   <= 3'd0;
            o_period  <= {P{1'b0}};
        end else if (starts) begin
            o_running <= 1'b1;
            o_curve   <= curve;
            o_period  <= period;
        end else if (is_done)
            o_running <= 1'b0;

    wire [AXES-1:0] stage_ready, stage_idle;
    wire            tick;
    // A cycle's pulses reach the output stages within the shortest period, so their slots are
    // still free then.
    pulse_source #(.P(P)) source (
        .i_clk(i_clk), .i_rst(i_rst), .i_period(o_period), .i_ready(o_running & &stage_ready),
        .o_tick(tick), .o_due(o_due), .o_count(o_count)
    );

    // Engines.
    wire [5:0] load, en;
    genvar number;
    generate
        for (number = 0; number < 6; number = number + 1) begin : engines
            assign load[number] = starts & curve == number;
            assign en[number]   = tick & o_curve == number;
        end
    endgenerate

    // Point-by-point comparison counts each axis to its end.
    localparam [1:0] PER_AXIS = 2'd1;

    wire [AXES-1:0] dda_line_pulse;
    dda_line #(.N(N), .AXES(AXES)) dda_line (
        .i_clk(i_clk), .i_rst(i_rst), .i_en(en[0]), .i_load(load[0]), .i_jv(first),
        .i_preset(jrx), .i_je(je), .i_negative(negative), .o_pulse(dda_line_pulse),
        .o_negative(o_dda_line_negative), .o_done(engine_done[0]), .o_jv(o_dda_line_jv),
        .o_jr(o_dda_line_jr), .o_je(o_dda_line_je)
    );

    wire [1:0] dda_arc_pulse;
    wire [1:0] dda_arc_negative;
    dda_arc #(.N(N)) dda_arc (
        .i_clk(i_clk), .i_rst(i_rst), .i_en(en[1]), .i_load(load[1]), .i_jvx(first[0 +: N]),
        .i_jvy(first[N +: N]), .i_preset(jrx), .i_unit(unit), .i_quadrant(quadrant),
        .i_crossings(crossings), .i_cw(cw), .i_jex(jex), .i_jey(jey), .o_pulse(dda_arc_pulse),
        .o_negative(dda_arc_negative), .o_done(engine_done[1]), .o_beat(o_dda_arc_beat),
        .o_unit(o_dda_arc_unit), .o_jvx(o_dda_arc_jvx), .o_jvy(o_dda_arc_jvy),
        .o_jrx(o_dda_arc_jrx), .o_jry(o_dda_arc_jry), .o_sumx(o_dda_arc_sumx),
        .o_sumy(o_dda_arc_sumy), .o_quadrant(o_dda_arc_quadrant),
        .o_crossings(o_dda_arc_crossings), .o_cw(o_dda_arc_cw), .o_jex(o_dda_arc_jex),
        .o_jey(o_dda_arc_jey), .o_last(o_dda_arc_last), .o_towards_is_y(o_dda_arc_towards_is_y),
        .o_feeds_nx(o_dda_arc_feeds_nx), .o_feeds_ny(o_dda_arc_feeds_ny),
        .o_at_end_x(o_dda_arc_at_end_x), .o_at_end_y(o_dda_arc_at_end_y),
        .o_stands_x(o_dda_arc_stands_x), .o_stands_y(o_dda_arc_stands_y),
        .o_stepping_out(o_dda_arc_stepping_out), .o_nx(o_dda_arc_nx), .o_ny(o_dda_arc_ny),
        .o_shrinks_x(o_dda_arc_shrinks_x), .o_shrinks_y(o_dda_arc_shrinks_y)
    );

    wire [1:0] dda_centred_arc_pulse;
    wire [1:0] dda_centred_arc_negative;
    dda_centred_arc #(.N(N)) dda_centred_arc (
        .i_clk(i_clk), .i_rst(i_rst), .i_en(en[2]), .i_load(load[2]), .i_x(first[0 +: N]),
        .i_y(first[N +: N]), .i_jrx(jrx), .i_jry(jry), .i_unit(unit), .i_quadrant(quadrant),
        .i_crossings(crossings), .i_cw(cw), .i_jex(jex), .i_jey(jey),
        .o_pulse(dda_centred_arc_pulse), .o_negative(dda_centred_arc_negative),
        .o_done(engine_done[2]), .o_beat(o_dda_centred_arc_beat), .o_unit(o_dda_centred_arc_unit),
        .o_x(o_dda_centred_arc_x), .o_y(o_dda_centred_arc_y), .o_jrx(o_dda_centred_arc_jrx),
        .o_jry(o_dda_centred_arc_jry), .o_sum(o_dda_centred_arc_sum),
        .o_quadrant(o_dda_centred_arc_quadrant), .o_crossings(o_dda_centred_arc_crossings),
        .o_cw(o_dda_centred_arc_cw), .o_jex(o_dda_centred_arc_jex), .o_jey(o_dda_centred_arc_jey),
        .o_last(o_dda_centred_arc_last), .o_towards_is_y(o_dda_centred_arc_towards_is_y),
        .o_feeds_nx(o_dda_centred_arc_feeds_nx), .o_feeds_ny(o_dda_centred_arc_feeds_ny),
        .o_at_end_x(o_dda_centred_arc_at_end_x), .o_at_end_y(o_dda_centred_arc_at_end_y),
        .o_stands_x(o_dda_centred_arc_stands_x), .o_stands_y(o_dda_centred_arc_stands_y),
        .o_stepping_out(o_dda_centred_arc_stepping_out), .o_nx(o_dda_centred_arc_nx),
        .o_ny(o_dda_centred_arc_ny), .o_shrinks_x(o_dda_centred_arc_shrinks_x),
        .o_shrinks_y(o_dda_centred_arc_shrinks_y)
    );

    wire [1:0] ppc_line_pulse;
    ppc_line #(.N(N)) ppc_line (
        .i_clk(i_clk), .i_rst(i_rst), .i_en(en[3]), .i_load(load[3]), .i_end_x(first[0 +: N]),
        .i_end_y(first[N +: N]), .i_negative(negative[1:0]), .i_rule(PER_AXIS),
        .i_larger_is_y(1'b0), .i_e({(N+1){1'b0}}), .o_pulse(ppc_line_pulse),
        .o_negative(o_ppc_line_negative), .o_done(engine_done[3]), .o_rule(o_ppc_line_rule),
        .o_larger_is_y(o_ppc_line_larger_is_y), .o_beat(o_ppc_line_beat), .o_fx(o_ppc_line_fx),
        .o_f(o_ppc_line_f), .o_end_x(o_ppc_line_end_x), .o_end_y(o_ppc_line_end_y),
        .o_jex(o_ppc_line_jex), .o_jey(o_ppc_line_jey), .o_e(o_ppc_line_e)
    );

    wire [1:0] ppc_arc_pulse;
    wire [1:0] ppc_arc_negative;
    ppc_arc #(.N(N)) ppc_arc (
        .i_clk(i_clk), .i_rst(i_rst), .i_en(en[4]), .i_load(load[4]), .i_cx(first[0 +: N]),
        .i_cy(first[N +: N]), .i_quadrant(quadrant), .i_crossings(crossings), .i_cw(cw),
        .i_jex(jex), .i_jey(jey), .i_rule(PER_AXIS), .i_larger_is_y(1'b0), .i_e({(N+4){1'b0}}),
        .o_pulse(ppc_arc_pulse), .o_negative(ppc_arc_negative), .o_done(engine_done[4]),
        .o_rule(o_ppc_arc_rule), .o_larger_is_y(o_ppc_arc_larger_is_y), .o_beat(o_ppc_arc_beat),
        .o_fx(o_ppc_arc_fx), .o_f(o_ppc_arc_f), .o_cx(o_ppc_arc_cx), .o_cy(o_ppc_arc_cy),
        .o_e(o_ppc_arc_e), .o_quadrant(o_ppc_arc_quadrant), .o_crossings(o_ppc_arc_crossings),
        .o_cw(o_ppc_arc_cw), .o_jex(o_ppc_arc_jex), .o_jey(o_ppc_arc_jey),
        .o_last(o_ppc_arc_last), .o_towards_is_y(o_ppc_arc_towards_is_y),
        .o_feeds_nx(o_ppc_arc_feeds_nx), .o_feeds_ny(o_ppc_arc_feeds_ny),
        .o_at_end_x(o_ppc_arc_at_end_x), .o_at_end_y(o_ppc_arc_at_end_y),
        .o_stands_x(o_ppc_arc_stands_x), .o_stands_y(o_ppc_arc_stands_y),
        .o_stepping_out(o_ppc_arc_stepping_out), .o_nx(o_ppc_arc_nx), .o_ny(o_ppc_arc_ny),
        .o_shrinks_x(o_ppc_arc_shrinks_x), .o_shrinks_y(o_ppc_arc_shrinks_y)
    );

    wire [AXES-1:0] brm_line_pulse;
    brm_line #(.N(N), .AXES(AXES)) brm_line (
        .i_clk(i_clk), .i_rst(i_rst), .i_en(en[5]), .i_load(load[5]), .i_value(first),
        .i_negative(negative), .o_pulse(brm_line_pulse), .o_negative(o_brm_line_negative),
        .o_done(engine_done[5]), .o_tg(o_brm_line_tg), .o_divider(o_brm_line_divider),
        .o_value(o_brm_line_value), .o_stages(o_brm_line_stages), .o_overflow(o_brm_line_overflow)
    );

    // The pulses of all engines; only one has any.
    wire [1:0] flat_pulse = dda_arc_pulse | dda_centred_arc_pulse | ppc_line_pulse | ppc_arc_pulse;
    wire [1:0] flat_sign  = (dda_arc_pulse & dda_arc_negative)
                          | (dda_centred_arc_pulse & dda_centred_arc_negative)
                          | (ppc_line_pulse & o_ppc_line_negative)
                          | (ppc_arc_pulse & ppc_arc_negative);
    wire [AXES-1:0] pulse, sign;
    assign pulse[1:0] = dda_line_pulse[1:0] | brm_line_pulse[1:0] | flat_pulse;
    assign sign[1:0]  = (dda_line_pulse[1:0] & o_dda_line_negative[1:0])
                      | (brm_line_pulse[1:0] & o_brm_line_negative[1:0]) | flat_sign;
    generate
        if (AXES > 2) begin : further
            assign pulse[AXES-1:2] = dda_line_pulse[AXES-1:2] | brm_line_pulse[AXES-1:2];
            assign sign[AXES-1:2]  = (dda_line_pulse[AXES-1:2] & o_dda_line_negative[AXES-1:2])
                                   | (brm_line_pulse[AXES-1:2] & o_brm_line_negative[AXES-1:2]);
        end
    endgenerate

    always @(posedge i_clk)
        if (i_rst) begin
            o_pulse    <= {AXES{1'b0}};
            o_negative <= {AXES{1'b0}};
        end else begin
            o_pulse    <= pulse;
            o_negative <= sign;
        end

    genvar axis;
    generate
        for (axis = 0; axis < AXES; axis = axis + 1) begin : axes
            step_dir #(.T(T)) stage (
                .i_clk(i_clk), .i_rst(i_rst), .i_length(i_length), .i_space(i_space),
                .i_setup(i_setup), .i_hold(i_hold), .i_pulse(o_pulse[axis]),
                .i_negative(o_negative[axis]), .o_ready(stage_ready[axis]), .o_step(o_step[axis]),
                .o_dir(o_dir[axis]), .o_idle(stage_idle[axis]), .o_pending(o_pending[axis]),
                .o_want(o_want[axis]), .o_turned(o_turned[axis]),
                .o_timer(o_timer[axis*T +: T]), .o_guard(o_guard[axis*T +: T])
            );
        end
    endgenerate

    // A curve still counts as running when its last pulse is in o_pulse.
    assign o_done = ~o_running & ~has_entry & o_decoder_state == 4'd0 & &stage_idle;
endmodule
