// What an arc by minimum deviation always does, for every command, sensible or not.
module minimum_deviation_arc_props #(
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
    input wire [N+1:0] jey
);
    reg first = 1'b1;
    always @(posedge clk) first <= 1'b0;

    wire [1:0]   pulse, negative, quadrant_q;
    wire         done, beat, due_x, due_y;
    wire [2:0]   crossings_q;
    wire [N-1:0] cx_q, cy_q;
    wire [N+1:0] f_q, jex_q, jey_q;
    wire cw_q, last_q, towards_is_y_q, feeds_nx_q, feeds_ny_q, at_end_x_q, at_end_y_q,
         stands_x_q, stands_y_q, stepping_out_q, nx_q, ny_q, shrinks_x_q, shrinks_y_q;

    minimum_deviation_arc #(.N(N)) arc (
        .i_clk(clk), .i_rst(first), .i_en(en), .i_load(load), .i_cx(cx), .i_cy(cy),
        .i_quadrant(quadrant), .i_crossings(crossings), .i_cw(cw), .i_jex(jex), .i_jey(jey),
        .o_pulse(pulse), .o_negative(negative), .o_done(done), .o_beat(beat), .o_due_x(due_x),
        .o_due_y(due_y), .o_f(f_q), .o_cx(cx_q), .o_cy(cy_q), .o_quadrant(quadrant_q),
        .o_crossings(crossings_q), .o_jex(jex_q), .o_jey(jey_q), .o_cw(cw_q), .o_last(last_q),
        .o_towards_is_y(towards_is_y_q), .o_feeds_nx(feeds_nx_q), .o_feeds_ny(feeds_ny_q),
        .o_at_end_x(at_end_x_q), .o_at_end_y(at_end_y_q), .o_stands_x(stands_x_q),
        .o_stands_y(stands_y_q), .o_stepping_out(stepping_out_q), .o_nx(nx_q), .o_ny(ny_q),
        .o_shrinks_x(shrinks_x_q), .o_shrinks_y(shrinks_y_q)
    );

    // The sweep's decoder once more, from the other outputs.
    wire last     = crossings_q == 0;
    wire feeds_nx = ~quadrant_q[1] ^ cw_q;
    wire feeds_ny = quadrant_q[1] ^ quadrant_q[0] ^ cw_q;
    wire x_stands = last & (jex_q == 0 | (jex_q[N+1] ^ feeds_nx));
    wire y_stands = last & (jey_q == 0 | (jey_q[N+1] ^ feeds_ny));

    // Net pulses.
    reg [N+1:0] net_x = 0, net_y = 0, far_x = 0, far_y = 0;
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

    // F by its definition: a pulse changes it by c'^2 - c^2, where the coordinate goes from c to c'. A
    // coordinate that leaves zero downwards ends that.
    reg  [N+1:0] f = 0;
    reg          is_out = 1'b0;
    wire [N+1:0] by_x = shrinks_x_q ? 1 - {1'b0, cx_q, 1'b0} : {1'b0, cx_q, 1'b0} + 1;
    wire [N+1:0] by_y = shrinks_y_q ? 1 - {1'b0, cy_q, 1'b0} : {1'b0, cy_q, 1'b0} + 1;
    always @(posedge clk)
        if (first | load) begin
            f      <= 0;
            is_out <= 1'b0;
        end else if (pulse != 0) begin
            f      <= f + (pulse[0] ? by_x : 0) + (pulse[1] ? by_y : 0);
            is_out <= is_out | (pulse[0] & shrinks_x_q & cx_q == 0)
                             | (pulse[1] & shrinks_y_q & cy_q == 0);
        end

    // What is fed towards zero is t, what is fed away from it a.
    wire signed [N+5:0] now  = {{4{f_q[N+1]}}, f_q};
    wire signed [N+5:0] t    = {6'd0, towards_is_y_q ? cy_q : cx_q};
    wire signed [N+5:0] a    = {6'd0, towards_is_y_q ? cx_q : cy_q};
    wire                due_t = towards_is_y_q ? due_y : due_x;
    wire                due_a = towards_is_y_q ? due_x : due_y;

    always @* if (!first) begin
        // What is kept decoded is what the quadrant says.
        assert (last_q == last);
        assert (towards_is_y_q == (quadrant_q[0] ^ cw_q));
        assert (feeds_nx_q == feeds_nx && feeds_ny_q == feeds_ny);
        // In the move beat the look of the beat before holds.
        if (beat) begin
            assert (at_end_x_q == (jex_q == 0) && at_end_y_q == (jey_q == 0));
            assert (stands_x_q == x_stands && stands_y_q == y_stands);
            assert (nx_q == (last ? jex_q[N+1] : feeds_nx));
            assert (ny_q == (last ? jey_q[N+1] : feeds_ny));
        end
        // Pulses in the second beat only; in the last quadrant none of an axis whose counter is spent,
        // as long as the other's is not.
        assert (!((done | ~beat) & pulse != 0));
        if (last & (jex_q != 0 | jey_q != 0)) begin
            if (pulse[0]) assert (jex_q != 0);
            if (pulse[1]) assert (jey_q != 0);
        end
        // A step has a pulse: of both axes, or of one.
        if (beat) assert (pulse != 0);
        // Pulses and end counter together are the way that was asked for: done means there.
        assert (net_x + jex_q == far_x);
        assert (net_y + jey_q == far_y);
        if (done) assert (net_x == far_x && net_y == far_y);
        if (~is_out && N <= 8) assert (f_q == f);
        // The nearest of the three steps. F there rises from t to both to a, and half the sum of neighbours
        // says which is nearer to 0.
        // (In narrow registers: sums of so many wide ones take the solver minutes.)
        if (beat && N <= 8) begin
            assert (due_t == !(now + a - t + a + 1 < 0));
            assert (due_a == (now + a - t - t + 1 < 0));
        end
    end
endmodule
