// What a point-by-point arc always does, for every command, sensible or not.
module ppc_arc_props #(
    parameter N = 24
) (
    input wire         clk,
    input wire         en,
    input wire         load,
    input wire [N-1:0] cx,
    input wire [N-1:0] cy,
    input wire [1:0]   quadrant,
    input wire [2:0]   crossings,
    input wire         cw,
    input wire [N+1:0] jex,
    input wire [N+1:0] jey,
    input wire [1:0]   rule,
    input wire         larger_is_y,
    input wire [N+3:0] e
);
    reg first = 1'b1;
    always @(posedge clk) first <= 1'b0;

    wire [1:0]   pulse, negative, beat, quadrant_q, rule_q;
    wire         done, fx, larger_is_y_q;
    wire [2:0]   crossings_q;
    wire [N-1:0] cx_q, cy_q;
    wire [N+1:0] f_q, jex_q, jey_q;
    wire [N+3:0] e_q;
    wire cw_q, last_q, towards_is_y_q, feeds_nx_q, feeds_ny_q, at_end_x_q, at_end_y_q,
         stands_x_q, stands_y_q, stepping_out_q, nx_q, ny_q, shrinks_x_q, shrinks_y_q;

    ppc_arc #(.N(N)) arc (
        .i_clk(clk), .i_rst(first), .i_en(en), .i_load(load), .i_cx(cx), .i_cy(cy),
        .i_quadrant(quadrant), .i_crossings(crossings), .i_cw(cw), .i_jex(jex), .i_jey(jey),
        .i_rule(rule), .i_larger_is_y(larger_is_y), .i_e(e), .o_pulse(pulse),
        .o_negative(negative), .o_done(done), .o_rule(rule_q), .o_larger_is_y(larger_is_y_q),
        .o_beat(beat), .o_fx(fx), .o_f(f_q), .o_cx(cx_q), .o_cy(cy_q), .o_e(e_q),
        .o_quadrant(quadrant_q), .o_crossings(crossings_q), .o_jex(jex_q), .o_jey(jey_q),
        .o_cw(cw_q), .o_last(last_q), .o_towards_is_y(towards_is_y_q),
        .o_feeds_nx(feeds_nx_q), .o_feeds_ny(feeds_ny_q), .o_at_end_x(at_end_x_q),
        .o_at_end_y(at_end_y_q), .o_stands_x(stands_x_q), .o_stands_y(stands_y_q),
        .o_stepping_out(stepping_out_q), .o_nx(nx_q), .o_ny(ny_q),
        .o_shrinks_x(shrinks_x_q), .o_shrinks_y(shrinks_y_q)
    );

    // The sweep's decoder once more, from the other outputs.
    wire last     = crossings_q == 0;
    wire feeds_nx = ~quadrant_q[1] ^ cw_q;
    wire feeds_ny = quadrant_q[1] ^ quadrant_q[0] ^ cw_q;
    wire x_stands = last & (jex_q == 0 | (jex_q[N+1] ^ feeds_nx));
    wire y_stands = last & (jey_q == 0 | (jey_q[N+1] ^ feeds_ny));


    // Net pulses. A counter takes a pulse the beat after it is sent.
    wire [N+1:0] x_sent = {{(N+1){negative[0]}}, 1'b1} & {(N+2){beat == 2'd2 & fx}};
    wire [N+1:0] y_sent = {{(N+1){negative[1]}}, 1'b1} & {(N+2){beat == 2'd2 & ~fx}};
    reg  [N+1:0] net_x = 0, net_y = 0, far_x = 0, far_y = 0;
    always @(posedge clk)
        if (first | load) begin
            net_x <= 0;
            net_y <= 0;
            far_x <= first ? 0 : jex;
            far_y <= first ? 0 : jey;
        end else begin
            if (pulse[0]) net_x <= negative[0] ? net_x - 1'b1 : net_x + 1'b1;
            if (pulse[1]) net_y <= negative[1] ? net_y - 1'b1 : net_y + 1'b1;
        end

    // The deviation function by its definition: every pulse changes it by c'^2 - c^2, where the
    // coordinate goes from c to c'. A coordinate that leaves zero downwards, which only stepping
    // out does, ends that.
    wire [N-1:0] c      = fx ? cx_q : cy_q;
    wire         lowers = fx ? shrinks_x_q : shrinks_y_q;
    wire [N+1:0] change = (lowers ? -{1'b0, c, 1'b0} : {1'b0, c, 1'b0}) + 1'b1;
    reg  [N+1:0] f = 0;
    reg          is_out = 1'b0;
    always @(posedge clk)
        if (first | load) begin
            f      <= 0;
            is_out <= 1'b0;
        end else if (beat == 2'd1) begin
            f      <= f + change;
            is_out <= is_out | (lowers & c == 0);
        end
    // Between the feed and the update the register has yet to take it.
    wire [N+1:0] due = {1'b0, c, 1'b0} + 1'b1;
    wire [N+1:0] f_sent = beat != 2'd2 ? f_q : lowers ? f_q - due : f_q + due;

    always @* if (!first) begin
        // What is kept decoded is what the quadrant says.
        assert (last_q == last);
        assert (towards_is_y_q == (quadrant_q[0] ^ cw_q));
        assert (feeds_nx_q == feeds_nx && feeds_ny_q == feeds_ny);
        // The last look holds until the counters take the pulse.
        if (beat != 2'd3) begin
            assert (at_end_x_q == (jex_q == 0) && at_end_y_q == (jey_q == 0));
            assert (stands_x_q == x_stands && stands_y_q == y_stands);
            assert (nx_q == (last ? jex_q[N+1] : feeds_nx));
            assert (ny_q == (last ? jey_q[N+1] : feeds_ny));
        end
        // One pulse a step, in the second beat; in the last quadrant never of an axis whose
        // counter is spent, as long as the other's is not.
        assert (!((done | beat != 2'd1) & pulse != 0));
        assert (pulse != 2'b11);
        if (last & (jex_q != 0 | jey_q != 0) & (beat == 2'd1 | beat == 2'd2))
            assert (fx ? jex_q != 0 : jey_q != 0);
        // Pulses and end counter together are the way that was asked for: done means there.
        assert (net_x + jex_q == far_x + x_sent);
        assert (net_y + jey_q == far_y + y_sent);
        if (done & rule_q == 2'd1) assert (net_x == far_x && net_y == far_y);
        if (~is_out) assert (f_sent == f);
    end
endmodule
